using System.Globalization;
using ErrorMatching.Geometry;

namespace ErrorMatching.Peers.Tests;

/// <summary>Lines and arcs in all their spellings.</summary>
internal sealed class MotionPart(ProgramDraft draft, RandomNumbers random, bool repeatsTurns)
    : ProgramPart(draft, random)
{
    private static readonly int[][] AxesOf = [[0, 1, 2], [2, 0, 1], [1, 2, 0]];

    public void WriteLine()
    {
        var motion = Chance(0.3) ? "G0" : "G1";
        var words = Distance() + Motion(motion) + FeedWord(motion);
        var any = false;
        for (var axis = 0; axis < 3; axis++)
        {
            if (Chance(0.5) || (axis == 2 && !any))
            {
                any = true;
                words += Coordinate(axis, Length());
            }
        }

        Block(words.Trim());
    }

    public void WriteArc(bool byRadius, bool full)
    {
        var (first, second, third) = (AxesOf[(int)Draft.Plane][0], AxesOf[(int)Draft.Plane][1], AxesOf[(int)Draft.Plane][2]);
        var ccw = Chance(0.5);
        var scale = Draft.IsInch ? 25.4 : 1;
        var words = Distance() + Centers();
        var start = (A: Draft.At[first], B: Draft.At[second]);
        var away = Uniform(0, 2 * Math.PI);
        var reach = Uniform(2, 40) / scale;
        var center = (A: Grid(start.A + (reach * Math.Cos(away))), B: Grid(start.B + (reach * Math.Sin(away))));
        var radius = Math.Sqrt(Square(center.A - start.A) + Square(center.B - start.B));

        // R says little about a center near half a turn, and near none or a whole one.
        var sweep = byRadius ? (Chance(0.3) ? Uniform(195, 330) : Uniform(25, 165)) : Uniform(10, 345);
        var angle = Math.Atan2(start.B - center.B, start.A - center.A) + ((ccw ? sweep : -sweep) * Math.PI / 180);
        var end = full ? start : (A: Grid(center.A + (radius * Math.Cos(angle))), B: Grid(center.B + (radius * Math.Sin(angle))));
        words += Motion(ccw ? "G3" : "G2") + FeedWord("G2");
        if (!full || Chance(0.5))
        {
            words += Coordinate(first, end.A) + Coordinate(second, end.B);
        }

        if (Chance(0.4))
        {
            words += Coordinate(third, Length());
        }

        if (byRadius)
        {
            words += $" R{Number(sweep > 180 ? -Up(radius) : Up(radius))}";
        }
        else
        {
            var (a, b) = Draft.HasAbsoluteCenters ? center : (center.A - start.A, center.B - start.B);
            words += $" {"IJK"[first]}{Number(Grid(a))} {"IJK"[second]}{Number(Grid(b))}";
        }

        if (repeatsTurns && Chance(0.5))
        {
            words += $" P{1 + Below(4)}";
        }

        Block(words.Trim());
    }

    /// <summary>Any simple motion: what comes between the blocks of a topic.</summary>
    public void WriteMotion()
    {
        switch (Below(4))
        {
            case 0: WriteArc(byRadius: true, full: false); break;
            case 1: WriteArc(byRadius: false, full: Chance(0.3)); break;
            default: WriteLine(); break;
        }
    }

    public void WritePlane()
    {
        WritePlaneCode();
        WriteMotion();
    }

    public void WritePlaneCode()
    {
        if (Chance(0.4))
        {
            Draft.Plane = Any(CoordinatePlane.XY, CoordinatePlane.ZX, CoordinatePlane.YZ);
            Block("G" + (17 + (int)Draft.Plane).ToString(CultureInfo.InvariantCulture));
        }
    }

    public void WriteUnits()
    {
        if (Chance(0.3))
        {
            Draft.IsInch = !Draft.IsInch;
            Block(Draft.IsInch ? "G20" : "G21");
            Restate();
        }

        WriteMotion();
    }

    private string Distance()
    {
        if (!Chance(0.2))
        {
            return "";
        }

        Draft.IsIncremental = !Draft.IsIncremental;
        return Draft.IsIncremental ? " G91" : " G90";
    }

    private string Centers()
    {
        if (!Chance(0.2))
        {
            return "";
        }

        Draft.HasAbsoluteCenters = !Draft.HasAbsoluteCenters;
        return Draft.HasAbsoluteCenters ? " G90.1" : " G91.1";
    }

    private string Motion(string code)
    {
        var isModal = Draft.Motion == code && Chance(0.7);
        Draft.Motion = code;
        return isModal ? "" : " " + (Chance(0.2) ? code.Insert(1, "0") : code);
    }

    private string FeedWord(string motion) => motion != "G0" && (Draft.FeedMode == "G93" || Chance(0.15)) ? " F" + Feed() : "";

    private string Coordinate(int axis, double target)
    {
        var value = Draft.IsIncremental ? Grid(target - Draft.At[axis]) : target;
        var stays = target == Draft.At[axis] && Draft.Motion is not ("G0" or "G1") && !Draft.IsIncremental && Chance(0.5);
        Draft.At[axis] = target;
        return stays ? "" : $" {"XYZ"[axis]}{Number(value)}";
    }

    private static double Square(double value) => value * value;

    private static double Up(double radius) => Math.Ceiling(radius * 1e4) / 1e4;
}
