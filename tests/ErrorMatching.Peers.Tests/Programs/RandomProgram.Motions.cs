using System.Globalization;
using ErrorMatching.Geometry;

namespace ErrorMatching.Peers.Tests;

/// <content>Lines and arcs in all their spellings.</content>
internal sealed partial class RandomProgram
{
    private static readonly int[][] AxesOf = [[0, 1, 2], [2, 0, 1], [1, 2, 0]];

    private void WriteLine()
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

    private void WriteArc(bool byRadius, bool full)
    {
        var (first, second, third) = (AxesOf[(int)_plane][0], AxesOf[(int)_plane][1], AxesOf[(int)_plane][2]);
        var ccw = Chance(0.5);
        var scale = _inch ? 25.4 : 1;
        var words = Distance() + Centers();
        var start = (A: _at[first], B: _at[second]);
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
            var (a, b) = _absoluteCenters ? center : (center.A - start.A, center.B - start.B);
            words += $" {"IJK"[first]}{Number(Grid(a))} {"IJK"[second]}{Number(Grid(b))}";
        }

        if (_topic is Topic.Turns or Topic.Everything && Chance(0.5))
        {
            words += $" P{1 + Below(4)}";
        }

        Block(words.Trim());
    }

    private void WritePlane()
    {
        WritePlaneCode();
        WriteMotion();
    }

    private void WritePlaneCode()
    {
        if (Chance(0.4))
        {
            _plane = Any(CoordinatePlane.XY, CoordinatePlane.ZX, CoordinatePlane.YZ);
            Block("G" + (17 + (int)_plane).ToString(CultureInfo.InvariantCulture));
        }
    }

    private void WriteUnits()
    {
        if (Chance(0.3))
        {
            _inch = !_inch;
            Block(_inch ? "G20" : "G21");
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

        _incremental = !_incremental;
        return _incremental ? " G91" : " G90";
    }

    private string Centers()
    {
        if (!Chance(0.2))
        {
            return "";
        }

        _absoluteCenters = !_absoluteCenters;
        return _absoluteCenters ? " G90.1" : " G91.1";
    }

    private string Motion(string code)
    {
        var isModal = _motion == code && Chance(0.7);
        _motion = code;
        return isModal ? "" : " " + (Chance(0.2) ? code.Insert(1, "0") : code);
    }

    private string FeedWord(string motion) => motion != "G0" && (_inverseTime || Chance(0.15)) ? " F" + Feed() : "";

    private string Coordinate(int axis, double target)
    {
        var value = _incremental ? Grid(target - _at[axis]) : target;
        var stays = target == _at[axis] && _motion is not ("G0" or "G1") && !_incremental && Chance(0.5);
        _at[axis] = target;
        return stays ? "" : $" {"XYZ"[axis]}{Number(value)}";
    }

    private static double Square(double value) => value * value;

    private static double Up(double radius) => Math.Ceiling(radius * 1e4) / 1e4;
}
