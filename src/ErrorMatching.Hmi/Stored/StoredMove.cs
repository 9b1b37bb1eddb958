using ErrorMatching.Cell;

namespace ErrorMatching.Hmi;

/// <summary>Where a correction moves its program most, as recorded by the step that computed it: at a key point or in a block.</summary>
public static class StoredMove
{
    private const string Block = "block ", Of = " of ";

    /// <summary>The place in the display language; null if no step records one.</summary>
    /// <param name="steps">The correction's history, step by step.</param>
    public static string? PlaceOf(IReadOnlyList<CorrectionStep> steps)
    {
        ArgumentNullException.ThrowIfNull(steps);
        if (steps.LastOrDefault(s => s.To == CorrectionState.Computed) is not { Basis: var basis })
        {
            return null;
        }

        // Warnings follow, one sentence each.
        var first = basis.IndexOf(". ", StringComparison.Ordinal) is >= 0 and var end ? basis[..(end + 1)] : basis;
        return Recorded.DisplacedAt.Read(first) is [_, var place] ? PlaceOf(place) : null;
    }

    /// <summary>The place in the display language.</summary>
    /// <param name="at">The place as recorded by a step.</param>
    public static string PlaceOf(string at)
    {
        ArgumentNullException.ThrowIfNull(at);
        return at.StartsWith(Block, StringComparison.Ordinal) ? at[Block.Length..] : RecordedText.Of(at.Split(Of)[0]);
    }
}
