namespace ErrorMatching.EndToEnd.Tests;

/// <summary>A straight piece of path; of no length where the tool only plunges.</summary>
internal sealed record CutSegment(Flat From, Flat To, CutterSide Side) : ICutPiece
{
    // A line through a vertex must meet one of its two pieces in spite of rounding.
    private const double EndSlack = 1e-9;

    public double DistanceTo(Flat place)
    {
        var span = To - From;
        var squared = span.Dot(span);
        var along = squared == 0 ? 0 : Math.Clamp((place - From).Dot(span) / squared, 0, 1);
        return (place - From - (span * along)).Length;
    }

    public IEnumerable<(double T, Flat Travel)> Crossings(Flat place, Flat direction)
    {
        var span = To - From;
        var across = direction.Cross(span);
        if (Math.Abs(across) > 1e-12 * span.Length)
        {
            var t = (From - place).Cross(span) / across;
            var along = (From - place).Cross(direction) / across;
            if (along * span.Length >= -EndSlack && (along - 1) * span.Length <= EndSlack)
            {
                yield return (t, span.Unit());
            }
        }
    }
}
