using ErrorMatching.Geometry;

namespace ErrorMatching.Freeform;

/// <summary>A pass along u, with its pieces from low to high u.</summary>
/// <param name="V">Its parameter.</param>
internal sealed record CutPass(double V)
{
    public List<CutPiece> Pieces { get; } = [];

    /// <summary>The first and the last place of each piece.</summary>
    public List<(Point2 First, Point2 Last)> Ends { get; } = [];

    /// <summary>The polylines of its pieces, kept until the next pass has been measured against them.</summary>
    public List<CenterLine> Lines { get; } = [];

    /// <summary>True if the ball had to be raised somewhere.</summary>
    public bool IsRaised { get; set; }
}
