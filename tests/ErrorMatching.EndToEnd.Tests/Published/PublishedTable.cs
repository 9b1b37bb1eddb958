using System.Globalization;
using ErrorMatching.Testing;

namespace ErrorMatching.EndToEnd.Tests;

/// <summary>A table of the paper as printed, misprints included (Wang, Tu, Gunawan, Sensors 2021, 21, 7660).
/// Rows by point label, columns by header.</summary>
internal sealed class PublishedTable
{
    private readonly string[] _header;
    private readonly Dictionary<string, string[]> _rows = [];

    private PublishedTable(string file)
    {
        var lines = File.ReadAllLines(Repository.PathTo("tests", "ErrorMatching.EndToEnd.Tests", "Data", "wang2021", file));
        _header = lines[0].Split(',');
        foreach (var line in lines.Skip(1))
        {
            var cells = line.Split(',');
            _rows.Add(cells[0], cells);
            Points.Add(cells[0]);
        }
    }

    public static PublishedTable CurvePart { get; } = new("table2_curve_part.csv");

    public static PublishedTable CurveBefore { get; } = new("table3_curve_counterpart_uncompensated.csv");

    public static PublishedTable CurveAfter { get; } = new("table4_curve_counterpart_compensated.csv");

    public static PublishedTable ComplexPart { get; } = new("table5_complex_part.csv");

    public static PublishedTable ComplexBefore { get; } = new("table6_complex_counterpart_uncompensated.csv");

    public static PublishedTable ComplexAfter { get; } = new("table7_complex_counterpart_compensated.csv");

    /// <summary>Point labels in the order of the table.</summary>
    public List<string> Points { get; } = [];

    public decimal At(string point, string column) =>
        decimal.Parse(_rows[point][Array.IndexOf(_header, column)], CultureInfo.InvariantCulture);

    /// <summary>Largest absolute difference of a column of this table from a column of another, over the points given,
    /// and the first point that has it.</summary>
    public (decimal Value, string Point) LargestDifference(
        string column, PublishedTable other, string otherColumn, IEnumerable<string> points, decimal add = 0) =>
        points.Select(p => (Value: Math.Abs(At(p, column) + add - other.At(p, otherColumn)), Point: p)).MaxBy(d => d.Value);
}
