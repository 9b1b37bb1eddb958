using System.Text;

namespace ErrorMatching.Nc;

/// <summary>Adds a constant to a value that the control computes: <c>[#1+5.]</c> becomes <c>[#1+5.+0.1]</c>. The expression itself stays as
/// it is, so its value changes by the constant, whatever its variables are.</summary>
internal static class AddedTerm
{
    private static readonly NumberStyle _style = new(Plus: true, Point: true, LeadingZero: true, FixedDecimals: -1, WholeDigits: 1);

    /// <summary>The text of the value with the constant.</summary>
    /// <param name="value">The value as written, behind the letter of its word.</param>
    /// <param name="syntax">The spelling of the program.</param>
    /// <param name="constant">What to add.</param>
    /// <returns>The new text; null if the spelling has no place for a sum.</returns>
    public static byte[]? To(ReadOnlySpan<byte> value, NcSyntax syntax, NcNumber constant)
    {
        var term = Encoding.ASCII.GetString(_style.Format(constant));
        var text = Encoding.Latin1.GetString(value);
        return syntax switch
        {
            NcSyntax.Iso or NcSyntax.LinuxCnc => Encoding.Latin1.GetBytes(InBrackets(text, term)),
            // Only a sum of products can be outside of brackets.
            NcSyntax.Okuma => Encoding.Latin1.GetBytes(text + term),
            NcSyntax.Siemens => Encoding.Latin1.GetBytes(IsSum(text, '(', ')') ? text + term : $"({text}){term}"),
            _ => null,
        };
    }

    private static string InBrackets(string text, string term)
    {
        if (text.Length < 2 || text[0] != '[' || Behind(text, 0, '[', ']') != text.Length)
        {
            return $"[{text}{term}]";
        }

        var inner = text[1..^1];
        return IsSum(inner, '[', ']') ? $"[{inner}{term}]" : $"[{text}{term}]";
    }

    // True if nothing in it binds less strongly than a sum: comparisons, logical operators and the like do.
    private static bool IsSum(string text, char open, char close)
    {
        for (var at = 0; at < text.Length; at++)
        {
            if (text[at] == open)
            {
                at = Behind(text, at, open, close) - 1;
            }
            else if (!(char.IsAsciiDigit(text[at]) || text[at] is '.' or '#' or '+' or '-' or '*' or '/' or ' ' or 'R' or 'r'))
            {
                return false;
            }
        }

        return true;
    }

    private static int Behind(string text, int at, char open, char close)
    {
        for (var depth = 0; at < text.Length; at++)
        {
            depth += text[at] == open ? 1 : text[at] == close ? -1 : 0;
            if (depth == 0)
            {
                return at + 1;
            }
        }

        return at;
    }
}
