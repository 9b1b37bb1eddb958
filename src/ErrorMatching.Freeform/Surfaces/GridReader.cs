using System.Globalization;
using ErrorMatching.Geometry;
using ErrorMatching.Measurement;
using ErrorMatching.Refusals;
using ErrorMatching.Reporting;

namespace ErrorMatching.Freeform;

/// <summary>Reads grids of points from CSV files: a header with <c>i</c>, <c>j</c>, <c>x</c>, <c>y</c> and <c>z</c> (<c>x_mm</c> also
/// works; other columns are ignored), then one line per point, in any order. i is the index of a point along its curve, j that of the
/// curve, both from 0 or 1 without gaps. Curves may have different numbers of points.</summary>
public static class GridReader
{
    /// <summary>Maximum number of points of a file.</summary>
    public const int MaxPoints = 100_000;

    /// <summary>Maximum index of a point or a curve. The time grows with the square of the longest line.</summary>
    public const int MaxNumber = 2_000;

    /// <summary>No machine tool is a kilometer long. A larger coordinate has lost its decimal point or has another unit.</summary>
    private const double LargestMm = 1e6;

    /// <summary>Points of one curve closer than this coincide.</summary>
    private const double SamePlaceMm = 1e-6;

    /// <summary>Reads a grid from a file.</summary>
    /// <param name="path">The file, as named in errors.</param>
    /// <exception cref="InputException">The file cannot be read or is not a grid. The message states where, what was found, and what
    /// is expected.</exception>
    public static PointGrid Read(string path) => Grid(NumberTable.Read(path, "i", "j", "x", "y", "z"));

    /// <summary>Reads a grid from the bytes of a file.</summary>
    /// <param name="bytes">UTF-8 with decimal points. Cells are separated by commas, or semicolons or tabs if the header has them.</param>
    /// <param name="file">The file name for errors.</param>
    /// <exception cref="InputException">Not a grid. The message states where, what was found, and what is expected.</exception>
    public static PointGrid Read(ReadOnlyMemory<byte> bytes, string file) => Grid(NumberTable.Read(bytes, file, "i", "j", "x", "y", "z"));

    /// <summary>Reads points without indices, for checking a surface: columns <c>x</c>, <c>y</c> and <c>z</c>, in file order.</summary>
    /// <param name="path">The file, as named in errors.</param>
    /// <exception cref="InputException">The file cannot be read or does not contain such points. The message states where, what was
    /// found, and what is expected.</exception>
    public static IReadOnlyList<Point3> ReadPoints(string path) => Points(NumberTable.Read(path, "x", "y", "z"));

    private static Point3[] Points(NumberTable table)
    {
        if (table.Count > MaxPoints)
        {
            throw Wrong(
                table,
                MaxPoints,
                "x",
                MeasurementError.TooManyPoints,
                ReportNumber.Count(table.Count, "point"),
                $"at most {MaxPoints}: is this the right file?");
        }

        return [
            .. Enumerable.Range(0, table.Count).Select(row => new Point3(
                Coordinate(table, row, "x"), Coordinate(table, row, "y"), Coordinate(table, row, "z")))];
    }

    private static PointGrid Grid(NumberTable table)
    {
        var points = Points(table);
        var rows = new Dictionary<(int J, int I), int>();
        for (var row = 0; row < points.Length; row++)
        {
            var at = (Number(table, row, "j"), Number(table, row, "i"));
            if (!rows.TryAdd(at, row))
            {
                throw Wrong(
                    table,
                    row,
                    "i",
                    MeasurementError.DuplicatePoint,
                    $"a second point with i = {at.Item2} and j = {at.Item1}",
                    $"each point once: line {table.Lines[rows[at]]} has this one already");
            }
        }

        var firstI = rows.Keys.Min(k => k.I);
        var curves = new List<IReadOnlyList<GridPoint>>();
        int? previous = null;
        foreach (var curve in rows.GroupBy(r => r.Key.J).OrderBy(g => g.Key))
        {
            var ordered = curve.OrderBy(r => r.Key.I).ToArray();
            if (curve.Key - (previous ?? curve.Key - 1) != 1)
            {
                throw Missing(table, ordered[0].Value, "j", $"no curve j = {previous + 1}, but j = {curve.Key}");
            }

            CheckCurve(table, ordered, firstI, points);
            curves.Add([.. ordered.Select(r => new GridPoint(r.Key.I, r.Key.J, points[r.Value]))]);
            previous = curve.Key;
        }

        return curves.Count > 1
            ? new(curves)
            : throw Wrong(
                table,
                0,
                "j",
                MeasurementError.MissingPoint,
                "a single curve",
                "at least two curves, each with a number j of its own: a surface needs points side by side");
    }

    /// <summary>Checks that a curve starts with the common first index, has no gap, and has no coinciding neighbors.</summary>
    private static void CheckCurve(NumberTable table, KeyValuePair<(int J, int I), int>[] curve, int firstI, Point3[] points)
    {
        for (var k = 0; k < curve.Length; k++)
        {
            var ((j, i), row) = curve[k];
            if (i != firstI + k)
            {
                throw Missing(table, row, "i", $"no point i = {firstI + k} on the curve j = {j}, but i = {i}");
            }

            if (k > 0 && (points[row] - points[curve[k - 1].Value]).Length < SamePlaceMm)
            {
                throw Wrong(
                    table,
                    row,
                    "x",
                    MeasurementError.DuplicatePoint,
                    $"the point i = {i}, j = {j} at the place of the point before it, in line {table.Lines[curve[k - 1].Value]}",
                    "neighbors at different places");
            }
        }

        if (curve.Length < 2)
        {
            throw Missing(table, curve[0].Value, "i", $"a single point on the curve j = {curve[0].Key.J}");
        }
    }

    private static InputException Missing(NumberTable table, int row, string column, string found) =>
        Wrong(
            table,
            row,
            column,
            MeasurementError.MissingPoint,
            found,
            "curves of at least two points numbered without gaps, i along each curve and j across: measure the missing points, or "
                + "correct the numbers");

    private static int Number(NumberTable table, int row, string column) =>
        int.TryParse(table[column][row], NumberStyles.None, CultureInfo.InvariantCulture, out var number) && number <= MaxNumber
            ? number
            : throw Wrong(
                table,
                row,
                column,
                MeasurementError.NumberOutOfRange,
                $"\"{table[column][row]}\" in column {column}",
                $"a whole number from 0 to {MaxNumber}");

    private static double Coordinate(NumberTable table, int row, string column)
    {
        var value = double.Parse(table[column][row], NumberStyles.Float, CultureInfo.InvariantCulture);
        return Math.Abs(value) <= LargestMm
            ? value
            : throw Wrong(
                table,
                row,
                column,
                MeasurementError.ImplausibleNumber,
                $"\"{table[column][row]}\" in column {column}",
                "a coordinate within a kilometer: has its decimal sign been lost?");
    }

    private static InputException Wrong(NumberTable table, int row, string column, string code, string found, string expected) =>
        MeasurementRefusal.Of(code, found, expected, table.File, table.Lines[row], table.ColumnOf(column));
}
