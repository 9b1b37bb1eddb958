using ErrorMatching.Reporting;

namespace ErrorMatching.Mating;

/// <summary>A tolerance chain with its total dimension.</summary>
/// <param name="WorstCase">The total dimension with every link at its worst limit.</param>
/// <param name="RootSumOfSquares">The total dimension if the links vary independently.</param>
public sealed record ReportChain(ChainDimension WorstCase, ChainDimension RootSumOfSquares)
{
    /// <summary>The links. The document does not contain them.</summary>
    public IReadOnlyList<ChainLink> Links { get; init; } = [];

    /// <summary>Creates the report's view of a chain.</summary>
    public static ReportChain Of(ToleranceChain chain)
    {
        ArgumentNullException.ThrowIfNull(chain);
        return new(chain.WorstCase(), chain.RootSumOfSquares()) { Links = chain.Links };
    }

    /// <summary>Writes it into the open object.</summary>
    internal void Write(ReportWriter w)
    {
        w.Number("nominalMm", WorstCase.NominalMm);
        w.Object("worstCase", () => Write(w, WorstCase));
        w.Object("rootSumOfSquares", () => Write(w, RootSumOfSquares));
    }

    /// <summary>Reads what <see cref="Write(ReportWriter)"/> writes.</summary>
    internal static ReportChain Read(ReportReader r)
    {
        var nominal = r.Number("nominalMm");
        return new(Read(r.Object("worstCase"), nominal), Read(r.Object("rootSumOfSquares"), nominal));
    }

    private static void Write(ReportWriter w, ChainDimension dimension)
    {
        w.Number("smallestMm", dimension.SmallestMm);
        w.Number("largestMm", dimension.LargestMm);
    }

    private static ChainDimension Read(ReportReader r, double nominalMm)
    {
        var (smallest, largest) = (r.Number("smallestMm"), r.Number("largestMm"));
        return smallest <= largest
            ? new(nominalMm, new(smallest - nominalMm, largest - nominalMm))
            : throw r.Refusal("smallestMm", "reversed-tolerance", "at most the largest size");
    }
}
