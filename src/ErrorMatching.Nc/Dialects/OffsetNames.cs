namespace ErrorMatching.Nc;

/// <summary>One way in which programs choose the offsets of a table, in order: <c>G54..G59</c>, <c>G154 P1..P99</c>.</summary>
/// <param name="Codes">The codes times ten; one if numbers distinguish the offsets.</param>
/// <param name="First">First number beside the code; 0 if there is none.</param>
/// <param name="Last">Last number.</param>
internal sealed record OffsetNames(IReadOnlyList<int> Codes, int First, int Last)
{
    /// <summary>The offset at a place, from 0; null if there is none.</summary>
    public (int Code, int Number)? At(int index) => index < 0 ? null
        : First > 0 ? (First + (long)index <= Last ? (Codes[0], First + index) : null)
        : index < Codes.Count ? (Codes[index], 0)
        : null;

    /// <summary>The place of an offset, from 0; -1 if it is not here.</summary>
    public int IndexOf((int Code, int Number) offset)
    {
        if (First > 0)
        {
            return offset.Code == Codes[0] && offset.Number >= First && offset.Number <= Last ? offset.Number - First : -1;
        }

        for (var i = 0; i < Codes.Count && offset.Number == 0; i++)
        {
            if (Codes[i] == offset.Code)
            {
                return i;
            }
        }

        return -1;
    }

    /// <summary>Reads such a list; null if it is none.</summary>
    /// <param name="text">G codes and ranges of them, or one code with a range of numbers.</param>
    /// <param name="letter">The letter of the numbers.</param>
    public static OffsetNames? Read(string text, byte letter)
    {
        var words = text.Split(' ', StringSplitOptions.RemoveEmptyEntries);
        var subjects = new List<SubjectRange>();
        var hasNumbers = words is [_, var numbers] && numbers[0] == letter;
        if (!SubjectRange.TryRead(hasNumbers ? words[0] : text, DialectTopic.Code, subjects, out _) || subjects.Exists(s => s.Word != "G"))
        {
            return null;
        }

        var codes = subjects.SelectMany(s => Enumerable.Range(0, ((s.Last - s.First) / s.Step) + 1).Select(i => s.First + (i * s.Step)));
        if (!hasNumbers)
        {
            return new([.. codes], 0, 0);
        }

        var range = SubjectRange.Numbers(words[1], ((char)letter).ToString());
        return range is { First: > 0 } && subjects is [{ IsRange: false }] ? new([.. codes], range.First, range.Last) : null;
    }
}
