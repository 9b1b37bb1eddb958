namespace ErrorMatching.Cell;

/// <summary>Names that every machine and every file system takes as they are, and that no program takes for anything but a file.</summary>
internal static class ProgramName
{
    private const int Most = 64;
    private static readonly string[] Devices = ["CON", "PRN", "AUX", "NUL", .. Enumerable.Range(0, 10).SelectMany(i => new[] { $"COM{i}", $"LPT{i}" })];

    /// <summary>What is wrong with a name; null if nothing is.</summary>
    public static string? Defect(string name) => name switch
    {
        "" => "an empty name",
        _ when name.Length > Most => $"a name of {name.Length} characters",
        _ when name.FirstOrDefault(c => !char.IsAsciiLetterOrDigit(c) && c is not ('.' or '_' or '-')) is var bad and not '\0' => $"a name with the character '{bad}'",
        _ when name[0] is '.' or '-' => $"a name that begins with '{name[0]}'",
        _ when name[^1] == '.' => "a name that ends with a point",
        _ when Devices.Contains(name.Split('.')[0], StringComparer.OrdinalIgnoreCase) => $"\"{name}\", which is a device of Windows",
        _ => null,
    };
}
