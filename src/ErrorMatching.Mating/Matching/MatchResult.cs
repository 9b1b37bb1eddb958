using ErrorMatching.Nc;

namespace ErrorMatching.Mating;

/// <summary>A match that may be used: the program to cut, and everything that led to it.</summary>
/// <param name="Input">What it was computed from.</param>
/// <param name="Before">The original program, interpreted.</param>
/// <param name="After">The program to cut, interpreted; the original itself where nothing is compensated.</param>
/// <param name="Maps">The features on the program, in the order of the job.</param>
/// <param name="Part">The part as compared.</param>
/// <param name="Counterpart">The measured counterpart as compared; null in feed-forward without one.</param>
/// <param name="Decision">What was decided for each feature.</param>
/// <param name="Wish">What was asked of the rewriter; null where nothing is compensated.</param>
/// <param name="Rewrite">What was changed, before the marker was inserted; null where nothing is compensated.</param>
/// <param name="Marker">The comment that was inserted; null where nothing was changed.</param>
/// <param name="Proof">What the comparison of both programs showed.</param>
public sealed record MatchResult(
    MatchInput Input,
    NcPath Before,
    NcPath After,
    IReadOnlyList<FeatureMap> Maps,
    AlignedMeasurement Part,
    AlignedMeasurement? Counterpart,
    MatingDecision Decision,
    DisplacementWish? Wish,
    Rewrite? Rewrite,
    Marker? Marker,
    NcProof Proof)
{
    /// <summary>The bytes of the program to cut.</summary>
    public ReadOnlyMemory<byte> Program => After.Program.Bytes;

    /// <summary>What was asked, as a file from which the proof can be made again;
    /// it asks for nothing where nothing is compensated.</summary>
    public WishFile WishFile() => Nc.WishFile.Of(
        Before,
        Wish ?? DisplacementWish.OfElements([]),
        Rewrite?.LeastIncrementMm ?? Math.Pow(10, -Before.Dialect.MetricDecimals),
        Marker?.TextIn(Before.Dialect.Syntax));
}
