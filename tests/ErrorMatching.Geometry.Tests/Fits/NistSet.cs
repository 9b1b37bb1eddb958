using System.Globalization;
using ErrorMatching.Testing;

namespace ErrorMatching.Geometry.Tests.Fits;

/// <summary>A certified regression set of the NIST Statistical Reference Datasets (public domain),
/// kept as the decimals it was published with.</summary>
internal sealed record NistSet(
    IReadOnlyList<DoubleDouble> X,
    IReadOnlyList<DoubleDouble> Y,
    IReadOnlyList<double> Coefficients,
    IReadOnlyList<double> StandardErrors,
    double ResidualStandardDeviation)
{
    public static NistSet Read(string name)
    {
        var lines = File.ReadAllLines(Repository.PathTo("tests", "ErrorMatching.Geometry.Tests", "Data", "Nist", name + ".dat"));
        var cells = lines.Select(l => l.Split(' ', StringSplitOptions.RemoveEmptyEntries)).ToArray();
        var certified = cells.Where(c => c.Length == 3 && c[0].StartsWith('B')).ToArray();
        var data = cells[
            (Array.FindIndex(lines, l => l.StartsWith("Data:  ", StringComparison.Ordinal) && l.TrimEnd().EndsWith('x')) + 1)..];
        return new(
            [.. data.Select(c => DoubleDouble.Parse(c[1]))],
            [.. data.Select(c => DoubleDouble.Parse(c[0]))],
            [.. certified.Select(c => Number(c[1]))],
            [.. certified.Select(c => Number(c[2]))],
            Number(cells.Single(c => c is ["Residual", "Standard", "Deviation", _])[3]));
    }

    /// <summary>Correct significant digits: the log relative error, 15 (all that is certified) at most;
    /// the log absolute error where zero is certified.</summary>
    public static double Digits(double actual, double certified)
    {
        var error = Math.Abs(actual - certified) / (certified == 0 ? 1 : Math.Abs(certified));
        return error == 0 ? 15 : Math.Min(15, -Math.Log10(error));
    }

    private static double Number(string text) => double.Parse(text, CultureInfo.InvariantCulture);
}
