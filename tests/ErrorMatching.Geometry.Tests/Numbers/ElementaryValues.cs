using System.Globalization;
using ErrorMatching.Testing;

namespace ErrorMatching.Geometry.Tests.Numbers;

/// <summary>Arguments and their values to 40 digits, from <c>Data/elementary.csv</c>, which <c>Data/elementary.py</c> writes by mpmath.</summary>
public sealed record ElementaryValues(double X, double Y, DoubleDouble Value)
{
    public static IReadOnlyList<ElementaryValues> Of(string name) => [
        .. File.ReadLines(Repository.PathTo("tests", "ErrorMatching.Geometry.Tests", "Data", "elementary.csv"))
            .Select(l => l.Split(','))
            .Where(w => w[0] == name)
            .Select(w => new ElementaryValues(
                double.Parse(w[1], CultureInfo.InvariantCulture), double.Parse(w[2], CultureInfo.InvariantCulture), DoubleDouble.Parse(w[3])))];
}
