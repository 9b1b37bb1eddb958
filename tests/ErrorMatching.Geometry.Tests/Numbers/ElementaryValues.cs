using System.Globalization;
using ErrorMatching.Testing;

namespace ErrorMatching.Geometry.Tests.Numbers;

/// <summary>Arguments and their values to 40 digits, from <c>Data/elementary.csv</c>, which <c>Data/elementary.py</c> writes by
/// mpmath.</summary>
public sealed record ElementaryValues(double X, double Y, DoubleDouble Value)
{
    public static IReadOnlyList<ElementaryValues> Of(string name) => [
        .. File.ReadLines(Repository.PathTo("tests", "ErrorMatching.Geometry.Tests", "Data", "elementary.csv"))
            .Select(l => l.Split(','))
            .Where(w => w[0] == name)
            .Select(w => new ElementaryValues(Number(w[1]), Number(w[2]), DoubleDouble.Parse(w[3])))];

    private static double Number(string text) => double.Parse(text, CultureInfo.InvariantCulture);
}
