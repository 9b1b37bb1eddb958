using ErrorMatching.Geometry;
using ErrorMatching.Json;

namespace ErrorMatching.Mating;

/// <summary>Reads limits and the chain that they may come from.</summary>
/// <param name="problems">The problems of the job.</param>
internal sealed class ToleranceReader(JobProblems problems)
{
    /// <summary>The chain of dimensions.</summary>
    public ToleranceChain ReadChain(JsonItem links) => new([.. links.Items.Select(ReadLink)]);

    /// <summary>The limits of a feature, or those that the chain gives it.</summary>
    /// <param name="item">Two limits, or a word for a rule.</param>
    /// <param name="chain">The job's chain; null if it has none.</param>
    public JobTolerance ReadTolerance(JsonItem item, ToleranceChain? chain)
    {
        if (item.Kind == JsonItemKind.List)
        {
            return new(ReadBand(item), ToleranceSource.Stated) { Place = item.Place };
        }

        var source = item.Text == "chain:rss" ? ToleranceSource.RootSumOfSquares : ToleranceSource.WorstCase;
        if (chain is null)
        {
            problems.Refuse(
                item,
                "chain-missing",
                $"\"{item.Text}\" in a job without \"toleranceChain\"",
                "a tolerance chain, or a lower and an upper limit");
            return new(ToleranceBand.Zero, source);
        }

        var computed = source == ToleranceSource.WorstCase ? chain.WorstCase() : chain.RootSumOfSquares();
        return new(computed.Band, source) { Place = item.Place };
    }

    private ChainLink ReadLink(JsonItem item) =>
        new(item["name"].Text, item["nominalMm"].Number, ReadBand(item["toleranceMm"]), (int)item["sign"].Number);

    private ToleranceBand ReadBand(JsonItem item)
    {
        var (lower, upper) = (item.Items[0].Number, item.Items[1].Number);
        if (lower <= upper)
        {
            return new(lower, upper);
        }

        problems.Refuse(item, "reversed-tolerance", $"the limits {item.Items[0].Text} and {item.Items[1].Text}", "the lower limit first");
        return ToleranceBand.Zero;
    }
}
