using System.Globalization;
using ErrorMatching.Geometry;
using ErrorMatching.Refusals;

namespace ErrorMatching.Jobs;

/// <summary>Reads and checks the numbers of a SPLINE.</summary>
/// <param name="values">The groups of the SPLINE.</param>
/// <param name="groups">The file, for errors.</param>
/// <param name="notes">Receives what is passed over.</param>
internal sealed class DxfSplineValues(DxfValues values, DxfGroups groups, DxfNotes notes)
{
    /// <summary>Reads it.</summary>
    public DrawnShape[] Read(DxfEntity entity)
    {
        var (degree, points, knots, weights) = (values.Integer(71, 3), values.Points(10), values.Numbers(40), values.Numbers(41));
        Check(entity, "knots", 72, knots.Count);
        Check(entity, "control points", 73, points.Count);
        if (points.Count == 0)
        {
            throw Fail(entity, values.Numbers(11).Count > 0
                ? "fit points without control points; control points and knots are expected, because fit points alone are no curve"
                : "no control points; at least 2 are expected in group 10");
        }

        if (degree is < 1 or > DxfLimits.MaxDegree)
        {
            throw Fail(entity, Text($"degree {degree}; 1 to {DxfLimits.MaxDegree} is expected"));
        }

        if (points.Count <= degree || knots.Count != points.Count + degree + 1)
        {
            throw Fail(
                entity,
                Text($"{points.Count} control points and {knots.Count} knots for degree {degree}; more control points than the degree and ")
                    + $"as many knots as both and 1 are expected");
        }

        CheckKnots(entity, degree, knots);
        if (weights.Count != 0 && weights.Count != points.Count)
        {
            throw Fail(entity, Text($"{weights.Count} weights for {points.Count} control points; equally many are expected"));
        }

        foreach (var weight in weights)
        {
            if (!(weight > 0))
            {
                throw Fail(entity, Text($"a weight of {weight}; positive numbers are expected"));
            }
        }

        var poles = new Point2[points.Count];
        var isSloped = false;
        for (var i = 0; i < poles.Length; i++)
        {
            poles[i] = new(points[i].X, points[i].Y);
            isSloped |= points[i].Z != points[0].Z;
        }

        if (isSloped)
        {
            notes.Count(DxfNote.Sloped, entity);
        }

        return [new SplineShape(degree, [.. knots], poles, weights.Count > 0 ? [.. weights] : null)];
    }

    private void CheckKnots(DxfEntity entity, int degree, List<double> knots)
    {
        for (var i = 1; i < knots.Count; i++)
        {
            if (!(knots[i] >= knots[i - 1]))
            {
                throw Fail(entity, Text($"knot {i + 1} ({knots[i]}) after {knots[i - 1]}; knots that do not descend are expected"));
            }
        }

        var (first, last) = (degree, knots.Count - degree - 1);
        if (!(knots[first] < knots[last]))
        {
            throw Fail(entity, Text($"all its knots are {knots[first]}; knots that ascend are expected"));
        }

        // Once more than the degree, each piece has poles of its own. Beyond it, a pole belongs to none.
        for (var i = 0; i + degree + 1 < knots.Count; i++)
        {
            if (knots[i] == knots[i + degree + 1])
            {
                throw Fail(entity, Text($"knot {knots[i]} more than {degree + 1} times; at most {degree + 1} times is expected"));
            }
        }
    }

    private void Check(DxfEntity entity, string what, int code, int count)
    {
        if (values.Integer(code, count) is var stated && stated != count)
        {
            throw Fail(entity, Text($"{count} {what}; group {code} says {stated}"));
        }
    }

    private static string Text(FormattableString text) => text.ToString(CultureInfo.InvariantCulture);

    private InputException Fail(DxfEntity entity, string problem) =>
        groups.FailAt("bad-spline", entity.Place, $"{entity.Label}: {problem}");
}
