using ErrorMatching.Refusals;

namespace ErrorMatching.Jobs;

/// <summary>Reads drawings by their extension.</summary>
internal static class DrawingReader
{
    /// <summary>Reads a drawing.</summary>
    /// <param name="file">The file.</param>
    /// <param name="unitMm">Millimeters in its unit, whatever it says itself; null if it says it.</param>
    /// <exception cref="InputException">It cannot be opened or read, or is of another kind.</exception>
    public static Drawing Read(string file, double? unitMm) => Path.GetExtension(file).ToUpperInvariant() switch
    {
        ".DXF" => DxfReader.Read(InputFile.Bytes(file, DxfLimits.MaxBytes), file, unitMm),
        var other => throw InputException.At("not-a-drawing", file, $"\"{other}\" is no drawing that is read; expected a .dxf file."),
    };
}
