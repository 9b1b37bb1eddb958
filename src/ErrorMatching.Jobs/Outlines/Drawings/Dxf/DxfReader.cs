using System.Globalization;
using ErrorMatching.Refusals;

namespace ErrorMatching.Jobs;

/// <summary>Reads the curves of a DXF file (R12 to 2018, text and binary) that are in planes parallel to XY.</summary>
internal static class DxfReader
{
    /// <summary>Reads a file.</summary>
    /// <param name="bytes">Its content.</param>
    /// <param name="file">Its name, for messages.</param>
    /// <param name="unitMm">Millimeters per unit of the drawing; null to take what the file states.</param>
    /// <exception cref="InputException">The file is no DXF file, is broken or too large, or has no curve.</exception>
    public static Drawing Read(byte[] bytes, string file, double? unitMm)
    {
        ArgumentNullException.ThrowIfNull(bytes);
        if (unitMm is { } stated && !(stated > 0 && double.IsFinite(stated)))
        {
            throw new ArgumentOutOfRangeException(nameof(unitMm), stated, "A positive length is expected.");
        }

        if (bytes.Length > DxfLimits.MaxBytes)
        {
            throw InputException.At("too-large", file, string.Create(
                CultureInfo.InvariantCulture,
                $"{bytes.Length} bytes; at most {DxfLimits.MaxBytes} bytes are expected. Save the outline alone as DXF"));
        }

        if (bytes.Length == 0)
        {
            throw InputException.At("not-dxf", file, "the file is empty; a DXF file is expected");
        }

        var notes = new DxfNotes();
        var source = new DxfFile(new(bytes, file), notes);
        var unit = unitMm is { } mm ? new DrawingUnit(mm, true) : Unit(source);
        var pen = new DxfPen(source.Groups, notes);
        new DxfBlocks(source, notes, pen).Draw(PlaneMap.Scaling(unit.Mm, unit.Mm));
        return pen.Curves.Count > 0
            ? new(file, unit, pen.Curves, notes.ToList())
            : throw InputException.At(
                "no-curve",
                file,
                $"no curve in a plane parallel to XY; LINE, ARC, CIRCLE, ELLIPSE, LWPOLYLINE, POLYLINE, SPLINE or INSERT of these is "
                    + $"expected. {string.Join(' ', notes.ToList())}".TrimEnd());
    }

    private static DrawingUnit Unit(DxfFile file)
    {
        if (file.Unit is not { Code: not 0 } unit)
        {
            return new(1, false);
        }

        double? mm = unit.Code switch
        {
            1 => 25.4,
            2 => 304.8,
            3 => 1_609_344,
            4 => 1,
            5 => 10,
            6 => 1000,
            7 => 1_000_000,
            8 => 0.0000254,
            9 => 0.0254,
            10 => 914.4,
            11 => 1e-7,
            12 => 1e-6,
            13 => 0.001,
            14 => 100,
            15 => 10_000,
            16 => 100_000,
            21 => 1_200_000 / 3937.0,
            22 => 100_000 / 3937.0,
            23 => 3_600_000 / 3937.0,
            24 => 1_200_000 / 3937.0 * 5280,
            _ => null,
        };
        return mm is { } length
            ? new(length, true)
            : throw file.Groups.FailAt("bad-unit", unit.Place, string.Create(
                CultureInfo.InvariantCulture,
                $"$INSUNITS is {unit.Code}; 1 (inch), 4 (millimeter) or another length of workpieces is expected: name the unit"));
    }
}
