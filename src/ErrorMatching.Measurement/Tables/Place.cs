using ErrorMatching.Refusals;

namespace ErrorMatching.Measurement;

/// <summary>A location in a file: line and cell, both from 1.</summary>
internal readonly record struct Place(string File, int Line, int Column)
{
    public static Place Start(string file) => new(file, 1, 1);

    public InputException Fail(string code, string found, string expected, Exception? cause = null) =>
        MeasurementRefusal.Of(code, found, expected, File, Line, Column, cause: cause);
}
