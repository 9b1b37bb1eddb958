namespace ErrorMatching.EndToEnd.Tests;

/// <summary>A straight element; it can shift and tilt.</summary>
internal sealed record PathLine(Flat Start, Flat End, double Offset) : IPathElement
{
    public double HeadingIn => (End - Start).Heading;

    public double HeadingOut => HeadingIn;

    public double BoundaryLength => (End - Start).Length;

    private Flat Direction => (End - Start).Unit();

    public (Flat Place, Flat Normal) BoundaryAt(double length) =>
        (Start + (Direction * length) + (Direction.Left * Offset), -Direction.Left);

    public IEnumerable<PathMove> Moves() => [new(End)];

    public Func<double, double> DrawDeviation(Random random)
    {
        var shift = Draw.Signed(random, 0.06, 0.3);
        var tilt = Draw.Between(random, -0.1, 0.1);
        return length => shift + (tilt * ((2 * length / BoundaryLength) - 1));
    }
}
