using System.Globalization;

namespace ErrorMatching.Reporting;

/// <summary>Formats coordinates of drawings. Hundredths of a pixel are finer than any screen or printer.</summary>
public static class SvgNumber
{
    // Characters of a sign, twelve digits, a point and two decimals, and some to spare.
    private const int Longest = 20;

    // Whole hundredths up to here are exact.
    private const double Most = 1e12;

    /// <summary>A coordinate.</summary>
    public static string Of(double value)
    {
        Span<char> text = stackalloc char[Longest];
        return Write(value, text, out var count) ? new(text[..count]) : Other(value);
    }

    /// <summary>A point, <c>x,y</c>.</summary>
    public static string Point(double x, double y)
    {
        Span<char> text = stackalloc char[(2 * Longest) + 1];
        if (!Write(x, text, out var count) || !Write(y, text[(count + 1)..], out var more))
        {
            return $"{Of(x)},{Of(y)}";
        }

        text[count] = ',';
        return new(text[..(count + 1 + more)]);
    }

    /// <summary>The points of a line, <c>x,y x,y</c>.</summary>
    public static string Points(IEnumerable<(double X, double Y)> points) => string.Join(' ', points.Select(p => Point(p.X, p.Y)));

    /// <summary>A label, shortened to a number of characters.</summary>
    public static string Label(string text, int length) => text.Length <= length ? text : text[..(length - 1)] + "…";

    // A large report has a hundred thousand coordinates: they are written as whole hundredths, without a format string.
    private static bool Write(double value, Span<char> text, out int count)
    {
        count = 0;
        if (!(Math.Abs(value) < Most))
        {
            return false;
        }

        var hundredths = (long)Math.Round(value * 100);
        if (hundredths < 0)
        {
            text[count++] = '-';
            hundredths = -hundredths;
        }

        var (whole, part) = Math.DivRem(hundredths, 100);
        whole.TryFormat(text[count..], out var written, default, CultureInfo.InvariantCulture);
        count += written;
        if (part > 0)
        {
            text[count++] = '.';
            text[count++] = (char)('0' + (part / 10));
            if (part % 10 > 0)
            {
                text[count++] = (char)('0' + (part % 10));
            }
        }

        return true;
    }

    private static string Other(double value) => (Math.Round(value, 2) + 0.0).ToString("0.##", CultureInfo.InvariantCulture);
}
