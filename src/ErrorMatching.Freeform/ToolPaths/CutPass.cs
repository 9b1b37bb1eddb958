namespace ErrorMatching.Freeform;

/// <summary>A pass along u: its pieces from low to high u, each with its polyline.</summary>
internal sealed record CutPass(double V)
{
    public List<CutPiece> Pieces { get; } = [];

    public List<CenterLine> Lines { get; } = [];
}
