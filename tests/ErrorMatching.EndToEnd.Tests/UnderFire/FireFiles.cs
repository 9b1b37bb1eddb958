using System.Globalization;
using System.Security.Cryptography;
using System.Text;
using ErrorMatching.Mating;
using ErrorMatching.Measurement;
using ErrorMatching.Testing;

namespace ErrorMatching.EndToEnd.Tests;

/// <summary>Measurements of which no two are alike, and the one program that each may become.</summary>
internal sealed class FireFiles
{
    private static readonly string Folder = Repository.PathTo("samples", "complex-mating");
    private static readonly string[] Part = File.ReadAllLines(Path.Combine(Folder, "part.csv"));

    // All slots of a machine get this program, so it has no number by which the control could confuse them.
    private static readonly byte[] Base = Encoding.Latin1.GetBytes(
        File.ReadAllText(Path.Combine(Folder, "counterpart.nc"), Encoding.Latin1).Replace("O0211", "(O0211)", StringComparison.Ordinal));

    private static readonly MatingJob Job = MatingJob.Parse(
        File.ReadAllBytes(Path.Combine(Folder, "job.json")), Path.Combine(Folder, "job.json"));
    private static readonly MeasurementFile Theoretical = MeasurementReader.Read(
        Path.Combine(Folder, "theoretical.csv"), MeasurementFormat.Points);

    private readonly Dictionary<string, string> _programs = new(StringComparer.Ordinal);

    /// <summary>The program that no correction has touched.</summary>
    public static ReadOnlySpan<byte> Original => Base;

    /// <summary>SHA-256 of the program that no correction has touched.</summary>
    public static string OriginalSha256 { get; } = Hash(Base);

    /// <summary>What every program that may be seen at a machine was made of:
    /// the name of the file, by the SHA-256 of the program.</summary>
    public IReadOnlyDictionary<string, string> FileByProgram => _programs;

    /// <summary>The measurement of a piece.</summary>
    /// <param name="slot">The slot whose job it is.</param>
    /// <param name="number">Number of the piece; each has its own deviations.</param>
    public (string Name, byte[] Bytes) Next(string slot, int number)
    {
        // Point 1 moves by up to 0.1 mm and point 4 by up to 0.01 mm: some of 100 x 1,000 pieces.
        var bytes = Encoding.ASCII.GetBytes(string.Join('\n', Part.Select(line => line.Split(',') switch
        {
            ["1", var x, var y] => string.Create(
                CultureInfo.InvariantCulture, $"1,{double.Parse(x, CultureInfo.InvariantCulture) + (number % 1000 * 0.0001):0.0000},{y}"),
            ["4", var x, var y] => string.Create(
                CultureInfo.InvariantCulture, $"4,{x},{double.Parse(y, CultureInfo.InvariantCulture) + (number / 1000 * 0.0001):0.0000}"),
            _ => line,
        })) + "\n");
        var name = string.Create(CultureInfo.InvariantCulture, $"{slot}_{number:000000}.csv");
        var part = MeasurementReader.Read(bytes, name, Job.Gauge.Format);
        var outcome = Matcher.Match(new(Job, Theoretical, part, null, "counterpart.nc", Base));
        Assert.Empty(outcome.Refusals);
        Assert.True(outcome.Result!.Proof.Holds);

        // Fails where another piece has the same program: nobody could tell which of the two a machine has.
        _programs.Add(Hash(outcome.Result.Program.Span), name);
        return (name, bytes);
    }

    /// <summary>SHA-256 as hexadecimal digits.</summary>
    public static string Hash(ReadOnlySpan<byte> bytes) => Convert.ToHexStringLower(SHA256.HashData(bytes));
}
