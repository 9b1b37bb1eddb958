using System.Globalization;

namespace ErrorMatching.Jobs;

/// <summary>Reports lower limits that exceed their upper limits, at the lower one. The job's reader reports this only once everything
/// else can be read, and for both limits together.</summary>
internal static class DraftLimits
{
    /// <summary>The code that the job's reader uses.</summary>
    public const string ReversedTolerance = "reversed-tolerance";

    /// <summary>The reversed limits of features and of the tolerance chain.</summary>
    /// <param name="draft">The draft.</param>
    public static IEnumerable<DraftProblem> Reversed(MatingDraft draft)
    {
        var features = draft.Features.Select(
            (f, i) => (Field: DraftPaths.Feature(i, "toleranceMm[0]"), f.Lower, f.Upper, IsUsed: f.Tolerance == FeatureDraft.Stated));
        var chain = draft.Chain.Select(
            (l, i) => (
                Field: string.Create(CultureInfo.InvariantCulture, $"$.toleranceChain[{i}].toleranceMm[0]"),
                l.Lower,
                l.Upper,
                IsUsed: true));
        return features.Concat(chain).Where(b => b.IsUsed && DraftNumber.Value(b.Lower) > DraftNumber.Value(b.Upper))
            .Select(b => new DraftProblem(
                b.Field,
                ReversedTolerance,
                $"the limits {b.Lower} and {b.Upper}",
                $"found the limits {b.Lower} and {b.Upper}; expected the lower limit first",
                "the lower limit first"));
    }
}
