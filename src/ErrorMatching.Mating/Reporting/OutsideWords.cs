namespace ErrorMatching.Mating;

/// <summary>Report texts on key points that a program is predicted to leave outside their limits, and on what the user can do.</summary>
public static class OutsideWords
{
    /// <summary>One sentence on the points that the compensation drives out, and one on those that stay outside; none if there are no
    /// such points.</summary>
    public static IEnumerable<string> Of(OutsideLimits outside)
    {
        ArgumentNullException.ThrowIfNull(outside);
        if (outside.DrivenOut is { Count: > 0 } driven)
        {
            yield return $"The compensation drives {Named(driven)} out of {Their(driven)} limits; uncompensated "
                + $"{(driven.Count == 1 ? "it is" : "they are")} within them.";
        }

        if (outside.Staying.ToArray() is { Length: > 0 } staying)
        {
            yield return $"{Capital(Named(staying))} {(staying.Length == 1 ? "stays" : "stay")} outside {Their(staying)} limits, with the "
                + $"compensation as without it.";
        }
    }

    /// <summary>What to decide before using the program; null if no point will be outside.</summary>
    public static string? ToDecide(OutsideLimits outside)
    {
        ArgumentNullException.ThrowIfNull(outside);
        return outside.Points is not { Count: > 0 } points ? null
            : $"{Capital(Named(points))} will be out of tolerance. Is that acceptable? If not, do not cut. "
                + "For the next parts, choose other points there in the job, or change their limits.";
    }

    private static string Named(IReadOnlyList<string> labels) =>
        labels.Count == 1 ? $"point {labels[0]}" : $"points {string.Join(", ", labels.SkipLast(1))} and {labels[^1]}";

    private static string Their(IReadOnlyList<string> labels) => labels.Count == 1 ? "its" : "their";

    private static string Capital(string text) => char.ToUpperInvariant(text[0]) + text[1..];
}
