namespace ErrorMatching.Measurement;

/// <summary>The unit of a file's coordinates.</summary>
public enum LengthUnit
{
    /// <summary>Millimeters.</summary>
    Millimeter,

    /// <summary>Inches of exactly 25.4 mm.</summary>
    Inch,
}

/// <summary>The unit that a file names.</summary>
internal sealed class UnitName
{
    private LengthUnit? _unit;

    /// <summary>The unit of the file: the named one, or millimeters if it names none.</summary>
    public LengthUnit Unit => _unit ?? LengthUnit.Millimeter;

    /// <summary>Notes a name of the unit, and returns it.</summary>
    /// <exception cref="Refusals.InputException">It is neither millimeters nor inches, or differs from an earlier one.</exception>
    public LengthUnit Note(Cell name)
    {
        LengthUnit? unit = name.Text.ToUpperInvariant() switch
        {
            "MM" => LengthUnit.Millimeter,
            "IN" or "INCH" or "INCHES" or "\"" => LengthUnit.Inch,
            _ => null,
        };
        if (unit is null || (_unit ?? unit) != unit)
        {
            throw name.Fail(
                MeasurementError.UnknownUnit,
                unit is null ? "millimeters or inches: export the measurement again" : "one unit in the whole file: export it again");
        }

        _unit = unit;
        return unit.Value;
    }
}
