using ErrorMatching.Geometry;
using ErrorMatching.Nc;

namespace ErrorMatching.Mating;

/// <summary>A usable match: the program to cut, and how it was computed.</summary>
/// <param name="Input">The input.</param>
/// <param name="Before">The original program, interpreted.</param>
/// <param name="After">The program to cut, interpreted; the original itself if nothing is compensated.</param>
/// <param name="Maps">The features mapped onto the program, in the order of the job.</param>
/// <param name="Part">The part's measurement as compared.</param>
/// <param name="Counterpart">The counterpart's measurement as compared; null in feed-forward without one.</param>
/// <param name="Decision">The decisions on the features.</param>
/// <param name="Prediction">The mating error that the program to cut will leave.</param>
/// <param name="Wish">The wish passed to the rewriter; null if nothing is compensated.</param>
/// <param name="Rewrite">The changes, before the marker was inserted; null if nothing is compensated.</param>
/// <param name="Marker">The inserted comment; null if nothing was changed.</param>
/// <param name="Proof">The result of comparing the two programs.</param>
public sealed record MatchResult(
    MatchInput Input,
    NcPath Before,
    NcPath After,
    IReadOnlyList<FeatureMap> Maps,
    AlignedMeasurement Part,
    AlignedMeasurement? Counterpart,
    MatingDecision Decision,
    MatingPrediction Prediction,
    DisplacementWish? Wish,
    Rewrite? Rewrite,
    Marker? Marker,
    NcProof Proof)
{
    // Smaller differences are those of rounded words and chords, or a small part of what the limits allow.
    private const double LeastBaseMm = 0.005;
    private const double LeastBaseShare = 0.1;

    /// <summary>In feedback, the counterparts measured so far, and what the program to cut corrects; otherwise null.</summary>
    public CounterpartLot? Lot { get; init; }

    /// <summary>What the measured points say about each other.</summary>
    public required MeasurementTrust Trust { get; init; }

    /// <summary>By what the correction is made; null if the job allows blocks alone.</summary>
    public CorrectionChoice? Correction { get; init; }

    /// <summary>The part put into the counterpart that the program to cut will make; null if the outline does not tell.</summary>
    public PairAssembly? Pair { get; init; }

    /// <summary>The bytes of the program to cut.</summary>
    public ReadOnlyMemory<byte> Program => After.Program.Bytes;

    /// <summary>Increment to which new coordinates are rounded, mm.</summary>
    public double LeastIncrementMm => Rewrite?.LeastIncrementMm ?? Elementary.Pow(10, -Before.Dialect.MetricDecimals);

    /// <summary>The key points on rounded corners: each says something about both elements together.</summary>
    public IEnumerable<KeyPointFoot> OnCorners => Maps.SelectMany(m => m.Passes[0].Feet).Where(f => f.OnCorner);

    /// <summary>The wish as a file from which the proof can be repeated; empty if nothing is compensated.</summary>
    public WishFile WishFile() => Nc.WishFile.Of(
        Before,
        Wish ?? DisplacementWish.OfElements([]),
        LeastIncrementMm,
        Marker?.TextIn(Before.Dialect.Syntax));

    /// <summary>The features of which the original program cuts so much elsewhere than their theoretical points are that it matters, and
    /// which the job keeps there: the largest difference, mm.</summary>
    internal IEnumerable<(string Feature, double Mm)> KeptBases => Maps.Zip(Prediction.Features)
        .Where(m => !m.First.Feature.CorrectsBase)
        .Select(m => (m.First.Feature, Mm: m.Second.Points.Select(p => p.BaseMm).MaxBy(Math.Abs)))
        .Where(m => Math.Abs(m.Mm) > Math.Max(LeastBaseMm, LeastBaseShare * NearestLimitMm(m.Feature)))
        .Select(m => (m.Feature.Name, m.Mm));

    private static double NearestLimitMm(JobFeature feature) =>
        Math.Min(Math.Abs(feature.Tolerance.Band.LowerMm), Math.Abs(feature.Tolerance.Band.UpperMm));

    /// <summary>What an independent judge needs to check the program to cut.</summary>
    public Certificate Certificate() =>
        Nc.Certificate.Of(Before, After.Program, Wish ?? DisplacementWish.OfElements([]), LeastIncrementMm, Proof);
}
