using System.Globalization;
using ErrorMatching.Geometry;

namespace ErrorMatching.Freeform;

/// <summary>A part of a CIRCLE or ELLIPSE of a STEP file, in millimeters: center + x cos t + y sin t.</summary>
/// <param name="Center">The center.</param>
/// <param name="X">From the center to t = 0.</param>
/// <param name="Y">From the center to a quarter turn.</param>
/// <param name="Start">First t, radians.</param>
/// <param name="Sweep">How far t ascends, radians; two pi for the whole curve.</param>
internal sealed record StepArc(Vector3 Center, Vector3 X, Vector3 Y, double Start, double Sweep)
{
    private const double SamePlaceMm = 1e-3;

    /// <summary>The part between two points: counterclockwise about the placement's axis, and a full turn if the points coincide.</summary>
    /// <param name="record">The CIRCLE or ELLIPSE.</param>
    /// <param name="first">Its radius along the placement's first axis, in the file's unit.</param>
    /// <param name="second">Its radius along the second axis.</param>
    /// <param name="from">Start of the part, mm.</param>
    /// <param name="to">End of the part, mm.</param>
    /// <param name="scale">Millimeters per unit.</param>
    public static StepArc Of(StepRecord record, double first, double second, Point3 from, Point3 to, double scale)
    {
        var frame = StepPlacement.Of(record.Instance(1));
        if (!(first > 0 && second > 0))
        {
            throw record.Fail(
                "bad-value",
                string.Create(CultureInfo.InvariantCulture, $"a radius of {Math.Min(first, second)}; a positive one is expected"));
        }

        var center = frame.Origin * scale;
        double Angle(Point3 p)
        {
            var d = new Vector3(p.X, p.Y, p.Z) - center;
            return Elementary.Atan2(d.Dot(frame.Y) / second, d.Dot(frame.X) / first);
        }

        var (a, b) = (Angle(from), Angle(to));
        var sweep = b - a;
        sweep -= Math.Tau * Math.Floor(sweep / Math.Tau);
        var closed = (to - from).Length <= SamePlaceMm && (sweep < 1 || sweep > Math.Tau - 1);
        return new(center, frame.X * (first * scale), frame.Y * (second * scale), a, closed || sweep <= 0 ? Math.Tau : sweep);
    }

    /// <summary>The place at an angle.</summary>
    public Point3 At(double t)
    {
        var p = Center + (X * Elementary.Cos(t)) + (Y * Elementary.Sin(t));
        return new(p.X, p.Y, p.Z);
    }
}
