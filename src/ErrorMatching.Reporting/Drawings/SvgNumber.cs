using System.Globalization;

namespace ErrorMatching.Reporting;

/// <summary>Formats coordinates of drawings. Hundredths of a pixel are finer than any screen or printer.</summary>
public static class SvgNumber
{
    /// <summary>A coordinate.</summary>
    public static string Of(double value) => (Math.Round(value, 2) + 0.0).ToString("0.##", CultureInfo.InvariantCulture);

    /// <summary>The points of a line, <c>x,y x,y</c>.</summary>
    public static string Points(IEnumerable<(double X, double Y)> points) => string.Join(' ', points.Select(p => $"{Of(p.X)},{Of(p.Y)}"));

    /// <summary>A label, shortened to a number of characters.</summary>
    public static string Label(string text, int length) => text.Length <= length ? text : text[..(length - 1)] + "…";
}
