using ErrorMatching.Reporting;

namespace ErrorMatching.Mating;

/// <summary>A range of a text.</summary>
/// <param name="Start">Index of its first character, from 0.</param>
/// <param name="Length">Number of characters.</param>
public sealed record TextSpan(int Start, int Length)
{
    /// <summary>Writes it into the open object.</summary>
    internal void Write(ReportWriter w)
    {
        w.Count("start", Start);
        w.Count("length", Length);
    }

    /// <summary>Reads what <see cref="Write"/> writes.</summary>
    /// <param name="r">The object.</param>
    /// <param name="text">The text that the range is in.</param>
    internal static TextSpan Read(ReportReader r, string text)
    {
        var (start, length) = (r.Count("start"), r.Count("length"));
        return start <= text.Length - length ? new(start, length) : throw r.Refusal("length", "too-large", "a range of the text");
    }
}
