namespace ErrorMatching.Measurement;

/// <summary>A place in a file: the line and the cell in it, both counted from 1.</summary>
internal readonly record struct Place(string File, int Line, int Column)
{
    public static Place Start(string file) => new(file, 1, 1);

    public MeasurementException Fail(string code, string found, string expected, Exception? cause = null) => new(code, found, expected, File, Line, Column, cause: cause);
}
