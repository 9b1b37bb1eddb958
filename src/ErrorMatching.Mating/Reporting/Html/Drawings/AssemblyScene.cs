using ErrorMatching.Geometry;
using ErrorMatching.Reporting;

namespace ErrorMatching.Mating;

/// <summary>What the drawings of one assembly share, so that before and after can be compared: boundary, exaggeration and
/// scale.</summary>
internal sealed class AssemblyScene
{
    /// <summary>Largest drawn deviation, as a fraction of the drawing's diagonal.</summary>
    public const double LargestShare = 1.0 / 20;

    /// <summary>Width of the drawn edge of a piece's material, pixels.</summary>
    public const double EdgePixels = 13;

    // The tool may leave a round corner between features that belongs to neither. Join ends up to this fraction of the diagonal apart.
    private const double CornerShare = 0.1;

    private const double MostWidth = 420, MostHeight = 460;

    private readonly IReadOnlyList<IReadOnlyList<DrawnFeature>> _chains;

    private AssemblyScene(IReadOnlyList<DrawnFeature> features, double diagonal)
    {
        Features = features;
        _chains = DisplacedBoundary.Chains(features, CornerShare * diagonal);
        LargestMm = features.SelectMany(f => f.Points).Max(p => Math.Max(
            Math.Abs(p.Part), Math.Max(Math.Abs(p.Before), Math.Abs(p.After))));
        Factor = LargestMm > 0 ? Math.Max(1, RoundNumber.AtMost(diagonal * LargestShare / LargestMm)) : 1;
        Point2[] all = [
            .. new Func<DrawnPoint, double>[]
            {
                p => p.Part,
                p => p.Before,
                p => p.After
            }.SelectMany(d => Displaced(d)).SelectMany(l => l)];
        (Low, High) = (new(all.Min(p => p.X), all.Min(p => p.Y)), new(all.Max(p => p.X), all.Max(p => p.Y)));
        PixelsPerMm = Math.Min(MostWidth / Math.Max(High.X - Low.X, diagonal / 100), MostHeight / Math.Max(High.Y - Low.Y, diagonal / 100));
    }

    /// <summary>The features in the order of cutting.</summary>
    public IReadOnlyList<DrawnFeature> Features { get; }

    /// <summary>Exaggeration of the deviations relative to the boundary, a round number.</summary>
    public double Factor { get; }

    /// <summary>The largest deviation, without sign.</summary>
    public double LargestMm { get; }

    /// <summary>Smallest coordinates of the drawing, mm.</summary>
    public Point2 Low { get; }

    /// <summary>Largest coordinates of the drawing, mm.</summary>
    public Point2 High { get; }

    public double PixelsPerMm { get; }

    /// <summary>The factor in words: <c>20 times</c> or <c>true to scale</c>.</summary>
    public string FactorText => Factor == 1 ? "true to scale" : ReportNumber.Short(Factor) + " times";

    /// <summary>The scene of some features, or null if there is nothing to draw.</summary>
    public static AssemblyScene? Of(IEnumerable<DrawnFeature?> features)
    {
        DrawnFeature[] drawn = [.. features.OfType<DrawnFeature>()];
        if (drawn.Length == 0)
        {
            return null;
        }

        Point2[] all = [.. drawn.SelectMany(f => Enumerable.Range(0, f.Segments + 1).Select(f.Vertex))];
        var (low, high) = (new Point2(all.Min(p => p.X), all.Min(p => p.Y)), new Point2(all.Max(p => p.X), all.Max(p => p.Y)));
        return new(drawn, low.DistanceTo(high));
    }

    /// <summary>The boundary with exaggerated deviations, shifted by a distance in pixels into the part.</summary>
    public IReadOnlyList<IReadOnlyList<Point2>> Displaced(Func<DrawnPoint, double> deviation, double asidePixels = 0)
    {
        var aside = asidePixels == 0 ? 0 : asidePixels / PixelsPerMm;
        return DisplacedBoundary.Of(_chains, (f, vertex) => (Factor * f.At(vertex, deviation)) + aside);
    }
}
