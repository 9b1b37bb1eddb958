using System.Globalization;
using System.Numerics;
using ErrorMatching.Geometry;

namespace ErrorMatching.Measurement;

/// <summary>A decimal number in its original spelling: <c>[+-] digits [. digits] [e [+-] digits]</c> with ASCII digits and a decimal
/// point.</summary>
internal readonly record struct DecimalNumber
{
    private const int LongestText = 1000;

    private readonly int _fraction;
    private readonly int _exponent;

    private DecimalNumber(string text, int fraction, int exponent) => (Text, _fraction, _exponent) = (text, fraction, exponent);

    /// <summary>The number with a decimal point and all digits.</summary>
    public string Text { get; }

    public double Value => double.Parse(Text, NumberStyles.Float, CultureInfo.InvariantCulture);

    public bool IsZero => Mantissa.IsZero;

    /// <summary>The value of one unit in the last digit.</summary>
    public double LastPlace => Elementary.Pow(10, _exponent - _fraction);

    /// <summary>The number times exactly 25.4, as the nearest double. The product is calculated in integers and rounded once.</summary>
    public double InchesInMillimeters =>
        double.Parse(
            string.Create(CultureInfo.InvariantCulture, $"{Mantissa * 254}E{_exponent - _fraction - 1}"),
            NumberStyles.Float,
            CultureInfo.InvariantCulture);

    private BigInteger Mantissa =>
        BigInteger.Parse(
            Text.Split('e', 'E')[0].Replace(".", "", StringComparison.Ordinal),
            NumberStyles.AllowLeadingSign,
            CultureInfo.InvariantCulture);

    /// <summary>Parses a number; null if the text is anything else, or longer than any number of a gauge.</summary>
    public static DecimalNumber? TryRead(string text, bool decimalComma)
    {
        var sign = decimalComma ? ',' : '.';
        var i = text.Length > 0 && text[0] is '+' or '-' ? 1 : 0;
        var whole = Digits(text, ref i);
        var fraction = 0;
        if (i < text.Length && text[i] == sign)
        {
            i++;
            fraction = Digits(text, ref i);
        }

        if (whole + fraction == 0 || text.Length > LongestText)
        {
            return null;
        }

        var exponent = 0;
        if (i < text.Length && text[i] is 'e' or 'E')
        {
            var start = ++i;
            i += i < text.Length && text[i] is '+' or '-' ? 1 : 0;
            if (Digits(text, ref i) == 0)
            {
                return null;
            }

            // An exponent too long for an integer is far outside double precision, which the value then shows.
            _ = int.TryParse(text.AsSpan(start), NumberStyles.AllowLeadingSign, CultureInfo.InvariantCulture, out exponent);
        }

        return i == text.Length ? new(text.Replace(',', '.'), fraction, exponent) : null;
    }

    private static int Digits(string text, ref int i)
    {
        var start = i;
        while (i < text.Length && char.IsAsciiDigit(text[i]))
        {
            i++;
        }

        return i - start;
    }
}
