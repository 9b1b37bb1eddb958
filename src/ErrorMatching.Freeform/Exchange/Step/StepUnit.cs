using ErrorMatching.Refusals;

namespace ErrorMatching.Freeform;

/// <summary>The length unit of a representation in a STEP file (ISO 10303-41).</summary>
internal static class StepUnit
{
    /// <summary>Returns the millimeters per length unit of a context.</summary>
    /// <exception cref="InputException">The context has no length unit, or an unknown one.</exception>
    public static double Millimeters(StepInstance context)
    {
        var units = context.Find("GLOBAL_UNIT_ASSIGNED_CONTEXT")
            ?? throw context.Records[0].Fail(
                "bad-unit", "a context without units (GLOBAL_UNIT_ASSIGNED_CONTEXT); a unit of length is expected");
        foreach (var unit in units.Instances(0))
        {
            if (unit.Find("LENGTH_UNIT") is not null)
            {
                return Length(unit, 0);
            }
        }

        throw units.Fail("bad-unit", "no LENGTH_UNIT among the units");
    }

    /// <summary>Returns the millimeters of a unit of length.</summary>
    /// <exception cref="InputException">It is no unit of length, or an unknown one.</exception>
    public static double OfLength(StepInstance unit) => unit.Find("LENGTH_UNIT") is not null
        ? Length(unit, 0)
        : throw unit.Records[0].Fail("bad-unit", "it is no LENGTH_UNIT; one is expected");

    /// <summary>Returns the degrees of a unit of angle.</summary>
    /// <exception cref="InputException">It is no unit of angle, or an unknown one.</exception>
    public static double OfAngle(StepInstance unit)
    {
        if (unit.Find("SI_UNIT") is { } si)
        {
            return si.Word(si.Values.Count - 1) == "RADIAN" && si.Word(si.Values.Count - 2) == ""
                ? 180 / Math.PI
                : throw si.Fail("bad-unit", "an angle in something else than RADIAN");
        }

        var record = unit.Get("CONVERSION_BASED_UNIT");
        var factor = record.Instance(record.Values.Count - 1).Records.FirstOrDefault(r => r.Values.Count >= 2)
            ?? throw record.Fail("bad-unit", "a unit without its measure");
        var inner = factor.Instance(1);
        return factor.Real(0) > 0 && inner.Find("SI_UNIT") is not null
            ? factor.Real(0) * OfAngle(inner)
            : throw factor.Fail("bad-unit", "a unit that is not a positive multiple of RADIAN");
    }

    private static double Length(StepInstance unit, int depth)
    {
        if (unit.Find("SI_UNIT") is { } si)
        {
            var name = si.Word(si.Values.Count - 1);
            return name is "METRE" or "METER"
                ? 1000 * Prefix(si, si.Word(si.Values.Count - 2))
                : throw si.Fail("bad-unit", $"a length in {ExchangeLimits.Quote(name)}; METRE is expected");
        }

        // A conversion-based unit: inch, foot.
        var record = unit.Get("CONVERSION_BASED_UNIT");
        var measure = record.Instance(record.Values.Count - 1);
        var factor = measure.Records.FirstOrDefault(r => r.Values.Count >= 2)
            ?? throw record.Fail("bad-unit", "a unit without its measure");
        var value = factor.Real(0);
        return value > 0 && depth < ExchangeLimits.MaxDepth
            ? value * Length(factor.Instance(1), depth + 1)
            : throw factor.Fail("bad-unit", "a unit that is not a positive multiple of another one");
    }

    private static double Prefix(StepRecord unit, string prefix) => prefix switch
    {
        "" => 1,
        "KILO" => 1e3,
        "HECTO" => 1e2,
        "DECA" => 1e1,
        "DECI" => 1e-1,
        "CENTI" => 1e-2,
        "MILLI" => 1e-3,
        "MICRO" => 1e-6,
        "NANO" => 1e-9,
        _ =>
            throw unit.Fail(
                "bad-unit",
                $"the prefix {ExchangeLimits.Quote(prefix)} of a length; MILLI, CENTI, none or another one of engineering is expected"),
    };
}
