namespace ErrorMatching.Hmi;

/// <summary>The components of the station and their licenses, as stated by the packages themselves.</summary>
internal static class Licenses
{
    /// <summary>Packages, each with its license (SPDX).</summary>
    public static IReadOnlyList<(string Package, string License)> Packages { get; } =
    [
        (".NET", "MIT"),
        ("Avalonia", "MIT"),
        ("Avalonia.Fonts.Inter", "MIT; Inter: OFL-1.1"),
        ("Avalonia.Remote.Protocol", "MIT"),
        ("Avalonia.Themes.Fluent", "MIT"),
        ("BouncyCastle.Cryptography", "MIT"),
        ("CsvHelper", "MS-PL OR Apache-2.0"),
        ("HarfBuzzSharp*", "MIT; HarfBuzz: MIT (Old)"),
        ("MathNet.Numerics", "MIT"),
        ("MicroCom.Runtime", "MIT"),
        ("Microsoft.Data.Sqlite.Core", "MIT"),
        ("Microsoft.Extensions.*", "MIT"),
        ("MQTTnet", "MIT"),
        ("Npgsql", "PostgreSQL"),
        ("OpenTelemetry*", "Apache-2.0"),
        ("Polly.Core", "BSD-3-Clause"),
        ("Serilog*", "Apache-2.0"),
        ("SkiaSharp*", "MIT; Skia, WebP: BSD-3-Clause; FreeType: FTL; libpng: libpng-2.0; zlib: Zlib"),
        ("SourceGear.sqlite3", "SQLite: public domain"),
        ("SQLitePCLRaw.*", "Apache-2.0"),
        ("SSH.NET", "MIT"),
        ("System.CommandLine", "MIT"),
    ];

    /// <summary>System libraries for drawing on Linux; they are not part of the station.</summary>
    public static IReadOnlyList<(string Package, string License)> OfLinux { get; } =
    [
        ("libX11", "MIT"),
        ("libXext", "MIT"),
        ("libXi", "MIT"),
    ];
}
