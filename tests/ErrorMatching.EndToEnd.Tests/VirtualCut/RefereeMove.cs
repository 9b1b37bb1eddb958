namespace ErrorMatching.EndToEnd.Tests;

/// <summary>
/// One programmed move. An arc has a center, a radius and a sweep (radians, counter-clockwise positive,
/// seen against the third axis of its plane); its radius is the mean of those at its two ends, so that a mismatch by rounding counts half.
/// </summary>
internal sealed record RefereeMove(string Block, int Line, bool Rapid, Spot From, Spot To, WorkPlane Plane, CutterSide Side)
{
    public bool IsArc { get; private init; }

    public Flat Center { get; private init; }

    public double Radius { get; private init; }

    public double Sweep { get; private init; }

    /// <summary>The move as an arc about a center; ends that coincide make a full circle.</summary>
    public RefereeMove Around(Flat center, bool counterClockwise)
    {
        var start = From.In(Plane) - center;
        var end = To.In(Plane) - center;
        if (Math.Abs(start.Length - end.Length) > 0.01 || start.Length < 1e-6)
        {
            throw new RefereeException($"line {Line}: the arc's ends are {start.Length:R} and {end.Length:R} from its center");
        }

        var sweep = Math.Atan2(start.Cross(end), start.Dot(end));
        if ((To.In(Plane) - From.In(Plane)).Length < 1e-9)
        {
            sweep = counterClockwise ? 2 * Math.PI : -2 * Math.PI;
        }
        else if (counterClockwise && sweep < 0)
        {
            sweep += 2 * Math.PI;
        }
        else if (!counterClockwise && sweep > 0)
        {
            sweep -= 2 * Math.PI;
        }

        return this with { IsArc = true, Center = center, Radius = (start.Length + end.Length) / 2, Sweep = sweep };
    }
}
