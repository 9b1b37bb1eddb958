using System.Globalization;
using ErrorMatching.Testing;

namespace ErrorMatching.EndToEnd.Tests;

/// <summary>What the tests read of a sample folder, by their own means.</summary>
internal static class SampleFile
{
    public static string Text(string sample, string file) => File.ReadAllText(Repository.PathTo("samples", sample, file));

    public static IReadOnlyList<(string Label, Flat Place)> Points(string sample, string file) =>
    [
        .. Text(sample, file).TrimEnd('\n').Split('\n').Skip(1).Select(line => line.Split(',')).Select(cells =>
            (
                cells[0],
                new Flat(double.Parse(cells[1], CultureInfo.InvariantCulture), double.Parse(cells[2], CultureInfo.InvariantCulture)))),
    ];

    public static IReadOnlyList<RefereeMove> Moves(string sample, string file) => RefereeInterpreter.Run(Text(sample, file));
}
