using System.Globalization;
using ErrorMatching.Refusals;

namespace ErrorMatching.Freeform;

/// <summary>A measure with its unit in a STEP file (ISO 10303-41): a length or an angle.</summary>
/// <param name="Value">Millimeters or degrees.</param>
/// <param name="IsAngle">True for an angle.</param>
/// <param name="UnitMm">Millimeters in the unit of a length, as the file states it.</param>
internal readonly record struct StepMeasure(double Value, bool IsAngle, double UnitMm)
{
    // No workpiece has a dimension beyond it: the unit is wrong, or the number.
    private const double Most = 1e6;

    /// <summary>True if an instance is a measure with a unit.</summary>
    public static bool Is(StepInstance instance) => RecordOf(instance) is not null;

    /// <summary>Reads a measure.</summary>
    /// <param name="instance">Its instance.</param>
    /// <param name="correct">What a unit of length really is, by what the file states.</param>
    /// <exception cref="InputException">It is no length or angle, or has no unit, or is not a number of a possible size.</exception>
    public static StepMeasure Of(StepInstance instance, Func<double, double> correct)
    {
        if (RecordOf(instance) is not var (record, at))
        {
            throw instance.Records[0].Fail("bad-value", "a measure with a unit is expected");
        }

        var value = record.At(at);
        var isAngle = value is { Kind: StepValueKind.Typed } && value.Text.Contains("PLANE_ANGLE_MEASURE", StringComparison.Ordinal);
        if (value is { Kind: StepValueKind.Typed } && !isAngle && !value.Text.EndsWith("LENGTH_MEASURE", StringComparison.Ordinal))
        {
            throw record.Fail("bad-value", $"a {ExchangeLimits.Quote(value.Text)}; a length or an angle is expected");
        }

        var number = record.Real(at);
        var (stated, unit) = isAngle ? (0.0, StepUnit.OfAngle(record.Instance(at + 1)))
            : StepUnit.OfLength(record.Instance(at + 1)) is var mm ? (mm, correct(mm)) : default;
        return Math.Abs(number * unit) <= Most
            ? new(number * unit, isAngle, stated)
            : throw record.Fail("bad-value", string.Create(
                CultureInfo.InvariantCulture, $"{number:g6} is larger than any dimension of a workpiece"));
    }

    // A simple MEASURE_REPRESENTATION_ITEM has its name before the value.
    private static (StepRecord Record, int At)? RecordOf(StepInstance instance) =>
        instance.Find("MEASURE_WITH_UNIT") is { } complex ? (complex, 0)
            : instance.Records is not [var simple] ? null
            : simple.Keyword.EndsWith("MEASURE_WITH_UNIT", StringComparison.Ordinal) ? (simple, 0)
            : simple.Keyword == "MEASURE_REPRESENTATION_ITEM" ? (simple, 1)
            : null;
}
