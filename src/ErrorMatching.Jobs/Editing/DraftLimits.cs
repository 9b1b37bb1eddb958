using System.Globalization;

namespace ErrorMatching.Jobs;

/// <summary>Says where a lower limit stands above its upper one, at the lower one. The job's reader says so only once everything else can
/// be read, and of both limits together.</summary>
internal static class DraftLimits
{
    /// <summary>The job's reader's word for it.</summary>
    public const string ReversedTolerance = "reversed-tolerance";

    /// <summary>The limits of features and of the tolerance chain that are the wrong way around.</summary>
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
