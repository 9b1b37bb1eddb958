using ErrorMatching.Cell;
using ErrorMatching.Reporting;

namespace ErrorMatching.Hmi;

/// <summary>Where a correction moves its program most, as recorded by the step that computed it: at a key point or in a block.</summary>
internal static class StoredMove
{
    /// <summary>The place in the display language; null if no step records one, as in a store of an earlier version.</summary>
    /// <param name="steps">The correction's history, step by step.</param>
    public static string? PlaceOf(IReadOnlyList<CorrectionStep> steps)
    {
        ArgumentNullException.ThrowIfNull(steps);
        return steps.LastOrDefault(s => s.To == CorrectionState.Computed)?.Basis.Parts is [var moved, ..] && moved.Is(Recorded.DisplacedAt)
            ? PlaceOf(moved.Values[1])
            : null;
    }

    /// <summary>The place in the display language. It is short: a block, or a point without its feature.</summary>
    /// <param name="at">The place as recorded by a step.</param>
    public static string PlaceOf(Statement at)
    {
        ArgumentNullException.ThrowIfNull(at);
        return at.Is(Recorded.AtBlock) ? at.Values[0].Sentence
            : RecordedText.Of(at.Is(Recorded.AtPointOf) ? Recorded.AtPoint.With(at.Values[0]) : at);
    }
}
