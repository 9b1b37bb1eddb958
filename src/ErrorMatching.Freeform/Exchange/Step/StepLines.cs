using System.Globalization;
using System.Text;
using ErrorMatching.Geometry;

namespace ErrorMatching.Freeform;

/// <summary>Collects the instances of a STEP file to write, numbered in order.</summary>
internal sealed class StepLines
{
    private const int Width = 120;

    private readonly StringBuilder _text = new();
    private int _count;

    public override string ToString() => _text.ToString();

    /// <summary>Writes an instance.</summary>
    /// <param name="content">The type with its attributes.</param>
    /// <returns>The reference to it: #number.</returns>
    public string Add(string content)
    {
        var id = string.Create(CultureInfo.InvariantCulture, $"#{++_count}");
        var line = $"{id}={content};";

        // Breaks long lists after commas. Strings occur only in short instances, which are not broken.
        var start = 0;
        while (line.Length - start > Width)
        {
            var end = content.Contains('\'', StringComparison.Ordinal) && content.Length < 4 * Width
                ? -1
                : line.IndexOf(',', start + Width - 20);
            if (end < 0)
            {
                break;
            }

            _text.Append(line, start, end + 1 - start).Append('\n');
            start = end + 1;
        }

        _text.Append(line, start, line.Length - start).Append('\n');
        return id;
    }

    public string Point(Point3 p) =>
        Add($"CARTESIAN_POINT('',({ExchangeNumber.Of(p.X)},{ExchangeNumber.Of(p.Y)},{ExchangeNumber.Of(p.Z)}))");

    /// <summary>Writes a point in the parameters.</summary>
    public string Point(Point2 p) => Add($"CARTESIAN_POINT('',({ExchangeNumber.Of(p.X)},{ExchangeNumber.Of(p.Y)}))");

    /// <summary>Writes a B-spline curve.</summary>
    /// <param name="knots">Its knots.</param>
    /// <param name="poles">References to its poles.</param>
    /// <param name="weights">Its weights; empty if it is not rational.</param>
    public string Curve(KnotVector knots, IEnumerable<string> poles, ReadOnlySpan<double> weights)
    {
        var shape = FormattableString.Invariant($"{knots.Degree},({string.Join(',', poles)}),.UNSPECIFIED.,.F.,.F.");
        var (times, values) = Knots(knots);
        return weights.IsEmpty
            ? Add($"B_SPLINE_CURVE_WITH_KNOTS('',{shape},{times},{values},.UNSPECIFIED.)")
            : Add(
                $"(BOUNDED_CURVE()B_SPLINE_CURVE({shape})B_SPLINE_CURVE_WITH_KNOTS({times},{values},.UNSPECIFIED.)CURVE()"
                    + $"GEOMETRIC_REPRESENTATION_ITEM()RATIONAL_B_SPLINE_CURVE({Reals(weights)})REPRESENTATION_ITEM(''))");
    }

    public string Surface(SplineSurface s, string name)
    {
        var rows = new StringBuilder("(");
        var weights = new StringBuilder("(");
        for (var i = 0; i < s.CountU; i++)
        {
            rows.Append(i == 0 ? "(" : ",(");
            for (var j = 0; j < s.CountV; j++)
            {
                rows.Append(j == 0 ? "" : ",").Append(Point(s.Poles[(i * s.CountV) + j]));
            }

            rows.Append(')');
            weights.Append(i == 0 ? "" : ",").Append(s.IsRational ? Reals(s.Weights.Slice(i * s.CountV, s.CountV)) : "");
        }

        var shape = FormattableString.Invariant($"{s.KnotsU.Degree},{s.KnotsV.Degree},{rows.Append(')')},.UNSPECIFIED.,.F.,.F.,.F.");
        var ((timesU, valuesU), (timesV, valuesV)) = (Knots(s.KnotsU), Knots(s.KnotsV));
        var knots = $"{timesU},{timesV},{valuesU},{valuesV},.UNSPECIFIED.";
        return s.IsRational
            ? Add(
                $"(BOUNDED_SURFACE()B_SPLINE_SURFACE({shape})B_SPLINE_SURFACE_WITH_KNOTS({knots})GEOMETRIC_REPRESENTATION_ITEM()"
                    + $"RATIONAL_B_SPLINE_SURFACE({weights.Append(')')})REPRESENTATION_ITEM({name})SURFACE())")
            : Add($"B_SPLINE_SURFACE_WITH_KNOTS({name},{shape},{knots})");
    }

    private static (string Times, string Values) Knots(KnotVector knots)
    {
        var (times, values) = (new List<string>(), new List<double>());
        foreach (var group in knots.Values.ToArray().GroupBy(k => k))
        {
            values.Add(group.Key);
            times.Add(group.Count().ToString(CultureInfo.InvariantCulture));
        }

        return ($"({string.Join(',', times)})", Reals(values.ToArray()));
    }

    private static string Reals(ReadOnlySpan<double> numbers)
    {
        var text = new StringBuilder("(");
        for (var i = 0; i < numbers.Length; i++)
        {
            text.Append(i == 0 ? "" : ",").Append(ExchangeNumber.Of(numbers[i]));
        }

        return text.Append(')').ToString();
    }
}
