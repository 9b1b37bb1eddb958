namespace ErrorMatching.EndToEnd.Tests;

/// <summary>An arc of path: from an angle (radians) by a signed sweep, a full circle included.</summary>
internal sealed record CutArc(Flat Center, double Radius, double FromAngle, double Sweep, CutterSide Side) : ICutPiece
{
    private const double EndSlack = 1e-9;

    public double DistanceTo(Flat place)
    {
        var spoke = place - Center;
        if (Covers(spoke.Heading, 0))
        {
            return Math.Abs(spoke.Length - Radius);
        }

        var start = Center + (Flat.Toward(FromAngle) * Radius);
        var end = Center + (Flat.Toward(FromAngle + Sweep) * Radius);
        return Math.Min((place - start).Length, (place - end).Length);
    }

    public IEnumerable<(double T, Flat Travel)> Crossings(Flat place, Flat direction)
    {
        var nearest = (Center - place).Dot(direction);
        var off = (Center - place).Cross(direction);
        var half = (Radius * Radius) - (off * off);
        if (half < 0)
        {
            yield break;
        }

        foreach (var t in new[] { nearest - Math.Sqrt(half), nearest + Math.Sqrt(half) })
        {
            var spoke = place + (direction * t) - Center;
            if (Covers(spoke.Heading, EndSlack / Radius))
            {
                yield return (t, Sweep > 0 ? spoke.Unit().Left : -spoke.Unit().Left);
            }
        }
    }

    private bool Covers(double heading, double slack)
    {
        var turned = (heading - FromAngle) * Math.Sign(Sweep) % (2 * Math.PI);
        turned = turned < 0 ? turned + (2 * Math.PI) : turned;
        return turned <= Math.Abs(Sweep) + slack || turned >= (2 * Math.PI) - slack;
    }
}
