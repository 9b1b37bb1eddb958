using ErrorMatching.Geometry;
using ErrorMatching.Refusals;

namespace ErrorMatching.Freeform;

/// <summary>Reads knots in STEP form: distinct values with multiplicities.</summary>
internal static class StepKnots
{
    /// <summary>Reads the knots from two attributes.</summary>
    /// <param name="record">The record with the attributes.</param>
    /// <param name="degree">The degree.</param>
    /// <param name="multiplicities">Index of the list of multiplicities.</param>
    /// <param name="knots">Index of the list of knots.</param>
    /// <exception cref="InputException">The lists do not contain numbers, or differ in length.</exception>
    /// <exception cref="GeometryException">No B-spline can have such knots.</exception>
    public static KnotVector Of(StepRecord record, int degree, int multiplicities, int knots)
    {
        var (times, values) = (record.Reals(multiplicities), record.Reals(knots));
        if (times.Length != values.Length)
        {
            throw record.Fail(
                "bad-value", $"{times.Length} multiplicities for {values.Length} knots; as many of the one as of the other are expected");
        }

        var all = new List<double>();
        for (var i = 0; i < times.Length; i++)
        {
            if (!(times[i] >= 1 && times[i] <= degree + 1 && times[i] == Math.Floor(times[i])))
            {
                throw record.Fail("bad-value", $"multiplicity {i + 1} of the knots is no whole number from 1 to {degree + 1}");
            }

            all.AddRange(Enumerable.Repeat(values[i], (int)times[i]));
        }

        return new(degree, all.ToArray());
    }
}
