using System.Globalization;
using ErrorMatching.Refusals;

namespace ErrorMatching.Freeform;

/// <summary>A directory entry of an IGES file.</summary>
/// <param name="Type">Entity type number, such as 128.</param>
/// <param name="Form">Form number.</param>
/// <param name="Sequence">Number of its first directory record: the D number, which is odd.</param>
/// <param name="Line">Line of that record in the file.</param>
/// <param name="FirstParameter">Number of its first parameter record, from 1.</param>
/// <param name="Transform">D number of its transformation matrix; 0 for none.</param>
/// <param name="Blanked">True if it is hidden.</param>
/// <param name="Dependent">True if it is only part of another entity.</param>
/// <param name="Label">Its label with the subscript; empty if it has none.</param>
internal sealed record IgesEntity(
    int Type, int Form, int Sequence, int Line, int FirstParameter, int Transform, bool Blanked, bool Dependent, string Label)
{
    public override string ToString() => string.Create(CultureInfo.InvariantCulture, $"entity {Type} at D{Sequence}");

    /// <summary>Reads the entry from two records (IGES 5.3, section 2.2.4.4).</summary>
    /// <param name="sections">The file.</param>
    /// <param name="record">Number of the first of the two records, from 0.</param>
    /// <exception cref="InputException">A field is not a number.</exception>
    public static IgesEntity Read(IgesSections sections, int record)
    {
        int Number(int row, int field) => NumberIn(sections, record + row, field);
        var status = sections.Field(record, 8).Trim().PadLeft(8, '0');
        var label = sections.Field(record + 1, 7).Trim();
        var subscript = sections.Field(record + 1, 8).Trim();
        return new(
            Number(0, 0),
            Number(1, 4),
            record + 1,
            sections.DirectoryLine(record),
            Number(0, 1),
            Math.Abs(Number(0, 6)),
            status is [_, not '0', ..],
            status[2..4] is "01" or "03",
            subscript is "" or "0" ? label : $"{label}({subscript})");
    }

    private static int NumberIn(IgesSections sections, int record, int field)
    {
        var text = sections.Field(record, field).AsSpan().Trim();
        var number = 0;
        return text.IsEmpty || int.TryParse(text, NumberStyles.AllowLeadingSign, CultureInfo.InvariantCulture, out number)
            ? number
            : throw InputException.At(
                "bad-number",
                sections.File,
                $"{ExchangeLimits.Quote(text.ToString())} in field {field + 1} of the directory; a whole number is expected",
                sections.DirectoryLine(record),
                (8 * field) + 1);
    }
}
