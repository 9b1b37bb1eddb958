namespace ErrorMatching.Nc;

/// <summary>Recognizes a computed value to which a constant was added. The value it has then is checked with the motion, which is
/// interpreted again; this only makes sure that nothing of the expression is lost or reordered.</summary>
internal static class ComputedSum
{
    /// <summary>True if a value is another one with one more term: behind it, behind it in parentheses, or at the end of its
    /// brackets.</summary>
    /// <param name="was">The value as it was.</param>
    /// <param name="now">The value in the result.</param>
    public static bool Extends(ReadOnlySpan<byte> was, ReadOnlySpan<byte> now)
    {
        if (EndsInTerm(now, was, [], []) || EndsInTerm(now, was, "("u8, ")"u8))
        {
            return true;
        }

        return now is [(byte)'[', .. var sum, (byte)']']
            && (EndsInTerm(sum, was, [], []) || (was is [(byte)'[', .. var inner, (byte)']'] && EndsInTerm(sum, inner, [], [])));
    }

    private static bool EndsInTerm(ReadOnlySpan<byte> sum, ReadOnlySpan<byte> was, ReadOnlySpan<byte> open, ReadOnlySpan<byte> close)
    {
        var length = open.Length + was.Length + close.Length;
        return sum.Length > length + 1
            && sum.StartsWith(open)
            && sum[open.Length..].StartsWith(was)
            && sum[(open.Length + was.Length)..].StartsWith(close)
            && IsTerm(sum[length..]);
    }

    // A sign, digits and at most one point.
    private static bool IsTerm(ReadOnlySpan<byte> text)
    {
        if (text[0] is not ((byte)'+' or (byte)'-'))
        {
            return false;
        }

        var (digits, points) = (0, 0);
        foreach (var b in text[1..])
        {
            digits += b is >= (byte)'0' and <= (byte)'9' ? 1 : 0;
            points += b == '.' ? 1 : 0;
        }

        return digits > 0 && points <= 1 && digits + points == text.Length - 1;
    }
}
