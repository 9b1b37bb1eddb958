using System.Globalization;
using ErrorMatching.Refusals;

namespace ErrorMatching.Measurement;

/// <summary>A cell of a table with its location and column name, both used in messages.</summary>
internal readonly record struct Cell(string Text, Place Place, string Column, bool DecimalComma)
{
    /// <summary>True if no job can describe the layout of the table.</summary>
    public bool IsFixed { get; init; }

    /// <summary>Parses the cell as a number.</summary>
    /// <exception cref="InputException">It is not a plain decimal number.</exception>
    public DecimalNumber Number()
    {
        if (DecimalNumber.TryRead(Text, DecimalComma) is not { } number)
        {
            var (code, expected) = NumberDefect.Of(Text, DecimalComma, IsFixed);
            throw Fail(code, expected);
        }

        return double.IsFinite(number.Value) && (number.Value != 0 || number.IsZero)
            ? number
            : throw Fail(MeasurementError.NumberOutOfRange, "a number within double precision");
    }

    /// <summary>Parses the cell as a whole number.</summary>
    /// <exception cref="InputException">It is not a whole number within 32 bits.</exception>
    public int Whole() => int.TryParse(Text, NumberStyles.AllowLeadingSign, CultureInfo.InvariantCulture, out var number)
        ? number
        : throw Fail(Text.Length == 0 ? MeasurementError.EmptyCell : MeasurementError.TextForNumber, "a whole number");

    /// <summary>Reads the cell as a name.</summary>
    /// <exception cref="InputException">It is empty or a spreadsheet formula.</exception>
    public string Label() =>
        Text.Length == 0 ? throw Fail(MeasurementError.EmptyCell, "a name")
        : NumberDefect.IsFormula(Text) && DecimalNumber.TryRead(Text, DecimalComma) is null
            ? throw Fail(MeasurementError.Formula, "a name: export values, not formulas")
        : Text;

    /// <summary>Creates an error about the cell.</summary>
    public InputException Fail(string code, string expected) =>
        Place.Fail(code, (Text.Length == 0 ? "an empty cell" : MeasurementRefusal.Quote(Text)) + $" in column {Column}", expected);
}
