using ErrorMatching.Testing;

namespace ErrorMatching.Peers.Tests;

/// <summary>The sample of a slot and its key, with a program as LinuxCNC runs it.</summary>
internal static class SlotJob
{
    /// <summary>How far the control may leave the programmed path, in mm (G64 P).</summary>
    public const double PathTolerance = 0.001;

    /// <summary>Writes the job into a folder.</summary>
    public static async Task LayOutAsync(string folder)
    {
        Directory.CreateDirectory(folder);
        foreach (var file in Directory.EnumerateFiles(Repository.PathTo("samples", "slot-mating")))
        {
            var text = await File.ReadAllTextAsync(file);
            await File.WriteAllTextAsync(
                Path.Combine(folder, Path.GetFileName(file)),
                Path.GetFileName(file) switch
                {
                    "counterpart.nc" => Program(text),
                    "job.json" => Once(text, "\"dialect\": \"delta-nc300\"", "\"dialect\": \"linuxcnc\""),
                    _ => text,
                });
        }
    }

    // Its own control's number and marks of the tape go, the path is held, and it is cut faster: nobody waits for chips.
    private static string Program(string text) => Once(Once(
        text.Replace("%\n", "", StringComparison.Ordinal).Replace("F500.", "F1500.", StringComparison.Ordinal)
            .Replace("F200.", "F3000.", StringComparison.Ordinal),
        "O0240\n", ""),
        "N10 G21\n", "N10 G21\nN15 G64 P0.001\n");

    private static string Once(string text, string old, string now) =>
        text.Split(old).Length == 2 ? text.Replace(old, now, StringComparison.Ordinal) : throw new InvalidDataException(old);
}
