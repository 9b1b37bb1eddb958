using System.Globalization;
using System.Text;

namespace ErrorMatching.Nc.Tests;

/// <summary>
/// Shows motions as short text, one after the other: R rapid, L line, CW and CCW arcs with their center behind @ and turns behind a plus, P
/// probe, C cycle, M reference or machine move, S spline; then the end as x,y,z with a question mark for what is not known.
/// </summary>
internal static class Moves
{
    /// <summary>The motions of a program behind a first block that goes to the origin.</summary>
    public static string Of(string dialect, string program) =>
        Of(Bench.Read("G90 G17 G40 G0 X0 Y0 Z0\n" + program + "\n", NcDialects.Named(dialect)), 1);

    public static string Of(NcPath path, int first = 0)
    {
        var text = new StringBuilder();
        for (var i = first; i < path.Motions.Length; i++)
        {
            var m = path.Motions[i];
            text.Append(text.Length > 0 ? " " : "")
                .Append(Kind(m.Kind))
                .Append(Number(m.End.X, m.UnknownEnd, AxisSet.X))
                .Append(',')
                .Append(Number(m.End.Y, m.UnknownEnd, AxisSet.Y))
                .Append(',')
                .Append(Number(m.End.Z, m.UnknownEnd, AxisSet.Z));
            if (m.IsArc)
            {
                text.Append('@')
                    .Append(Number(m.Center.X))
                    .Append(',')
                    .Append(Number(m.Center.Y))
                    .Append(m.Turns > 0 ? "+" + m.Turns.ToString(CultureInfo.InvariantCulture) : "");
            }
        }

        return text.ToString();
    }

    /// <summary>A place as x,y,z with a question mark for what is not known.</summary>
    public static string At(Geometry.Point3 place, AxisSet unknown) =>
        $"{Number(place.X, unknown, AxisSet.X)},{Number(place.Y, unknown, AxisSet.Y)},{Number(place.Z, unknown, AxisSet.Z)}";

    private static string Kind(MotionKind kind) => kind switch
    {
        MotionKind.Rapid => "R",
        MotionKind.Line => "L",
        MotionKind.ArcClockwise => "CW",
        MotionKind.ArcCounterClockwise => "CCW",
        MotionKind.Probe => "P",
        MotionKind.Cycle => "C",
        MotionKind.Reference => "M",
        _ => "S",
    };

    private static string Number(double value, AxisSet unknown, AxisSet axis) => (unknown & axis) != AxisSet.None ? "?" : Number(value);

    private static string Number(double value) => Math.Round(value, 4) is 0 ? "0" : value.ToString("0.####", CultureInfo.InvariantCulture);
}
