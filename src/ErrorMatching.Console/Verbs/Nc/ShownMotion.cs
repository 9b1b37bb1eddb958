using System.Globalization;
using System.Text.Json;
using ErrorMatching.Geometry;
using ErrorMatching.Nc;

namespace ErrorMatching.Console;

/// <summary>A motion in the words that scripts read: absolute millimeters, rounded to remove binary noise. A coordinate that the program
/// has not set yet is 0, as on an interpreter that starts at the origin; one that only the machine knows keeps its last programmed value.
/// Both are listed in <c>unknown</c>.</summary>
internal sealed class ShownMotion
{
    private const int Decimals = 9;

    private readonly NcMotion _motion;
    private readonly Point3? _center;

    /// <summary>A motion of a program.</summary>
    public ShownMotion(NcPath path, int index)
        : this(path, index, path.Motions[index], path.Motions.AssumedEnd(index))
    {
    }

    /// <summary>A motion of the tool's center.</summary>
    public ShownMotion(CompensatedPath center, int index)
        : this(center.Path, index, Of(center, center.Motions[index]), Assumed(center, center.Motions[index]))
    {
    }

    private ShownMotion(NcPath path, int index, in NcMotion motion, Point3 end)
    {
        (Index, _motion, End) = (index, motion, end);
        Block = path.Program.NumberOf(path.Program[_motion.Block]);
        _center = _motion.IsArc ? _motion.Plane.Lift(_motion.Center, _motion.Plane.Height(_motion.Start)) : null;
    }

    /// <summary>Names of the fields, in order.</summary>
    public static IReadOnlyList<string> Fields { get; } = [
        "index", "line", "block", "kind", "x", "y", "z", "cx", "cy", "cz", "plane", "turns", "feed"];

    /// <summary>Position among the motions, from 0.</summary>
    public int Index { get; }

    /// <summary>The N word of its block as written, or an empty text.</summary>
    public string Block { get; }

    /// <summary>The line of its block, from 1.</summary>
    public int Line => _motion.Block + 1;

    /// <summary>rapid, line, arc-cw, arc-ccw or probe. Cycles and moves to machine positions are rapids to the known part of their
    /// end.</summary>
    public string Kind => KindOf(_motion.Kind);

    /// <summary>Its end point.</summary>
    public Point3 End { get; }

    /// <summary>Axes whose end the program does not define: x, y, z.</summary>
    public IEnumerable<string> Unknown => new[]
    {
        (AxisSet.X, "x"),
        (AxisSet.Y, "y"),
        (AxisSet.Z, "z")
    }.Where(a => (_motion.UnknownEnd & a.Item1) != AxisSet.None).Select(a => a.Item2);

    /// <summary>The word for a kind of motion.</summary>
    public static string KindOf(MotionKind kind) => kind switch
    {
        MotionKind.Line => "line",
        MotionKind.ArcClockwise => "arc-cw",
        MotionKind.ArcCounterClockwise => "arc-ccw",
        MotionKind.Probe => "probe",
        _ => "rapid",
    };

    /// <summary>A number without an exponent, rounded to remove binary noise.</summary>
    public static string Text(double? value) => value is { } v ? Clean(v).ToString("0.#########", CultureInfo.InvariantCulture) : "";

    /// <summary>The values of the fields as texts, as <see cref="MotionLines"/> prints them.</summary>
    public IReadOnlyList<string> Cells() =>
    [
        Index.ToString(CultureInfo.InvariantCulture), Line.ToString(CultureInfo.InvariantCulture), Block, Kind,
        Text(End.X), Text(End.Y), Text(End.Z), Text(_center?.X), Text(_center?.Y), Text(_center?.Z),
        _motion.Plane.ToString(), _motion.Turns.ToString(CultureInfo.InvariantCulture), Text(_motion.Feed),
    ];

    /// <summary>Writes the fields as members of the current object; null for unknown or meaningless values.</summary>
    public void Write(Utf8JsonWriter json)
    {
        json.WriteNumber("index", Index);
        json.WriteNumber("line", Line);
        json.WriteString("block", Block);
        json.WriteString("kind", Kind);
        foreach (var (name, value) in new (string, double?)[]
        {
            ("x", End.X),
            ("y", End.Y),
            ("z", End.Z),
            ("cx", _center?.X),
            ("cy", _center?.Y),
            ("cz", _center?.Z)
        })
        {
            json.Number(name, value is { } v ? Clean(v) : double.NaN);
        }

        json.WriteString("plane", _motion.Plane.ToString());
        json.WriteNumber("turns", _motion.Turns);
        json.Number("feed", Clean(_motion.Feed));
        json.WriteStartArray("unknown");
        foreach (var axis in Unknown)
        {
            json.WriteStringValue(axis);
        }

        json.WriteEndArray();
    }

    private static NcMotion Of(CompensatedPath center, in CompensatedMotion motion) => center.Path.Motions[motion.Motion] with
    {
        Kind = motion.Kind,
        Start = motion.Start,
        End = motion.End,
        Center = motion.Center,
        Turns = motion.Turns,
        UnknownEnd = motion.UnknownEnd,
    };

    // Coordinates that the program does not determine are those of the programmed motion.
    private static Point3 Assumed(CompensatedPath center, in CompensatedMotion motion)
    {
        var assumed = center.Path.Motions.AssumedEnd(motion.Motion);
        return new(
            (motion.UnknownEnd & AxisSet.X) != AxisSet.None ? assumed.X : motion.End.X,
            (motion.UnknownEnd & AxisSet.Y) != AxisSet.None ? assumed.Y : motion.End.Y,
            (motion.UnknownEnd & AxisSet.Z) != AxisSet.None ? assumed.Z : motion.End.Z);
    }

    // Adding zero turns -0 into 0.
    private static double Clean(double value) => Math.Round(value, Decimals) + 0.0;
}
