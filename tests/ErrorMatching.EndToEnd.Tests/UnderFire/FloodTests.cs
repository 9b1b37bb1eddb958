using System.Diagnostics;
using System.Globalization;
using System.Text;

namespace ErrorMatching.EndToEnd.Tests;

/// <summary>Good files among duplicates, strangers, truncated and hostile ones:
/// every one is accounted for, and only good ones reach the machine.</summary>
/// <remarks>150 files here, 10,000 by <c>tests/fire flood 10000</c>.</remarks>
public sealed class FloodTests
{
    private static readonly int Files = int.Parse(
        Environment.GetEnvironmentVariable("ERRORMATCH_FLOOD") ?? "150", CultureInfo.InvariantCulture);

    // Names that a shell, a path, a spreadsheet or a terminal would take for something else.
    private static readonly string[] HostileNames =
    [
        "$(touch pwned)", "%2e%2e%2fpasswd", "a\nb", "=cmd|' C calc'!A0", "con", "\u001b[2J", "\u202Evsc", "S00_1;rm -rf ~", "S00_'",
        "--help", ".hidden", new string('x', 240), "S00_\u0661",
    ];

    [Fact]
    public async Task Every_file_of_a_flood_is_accounted_for()
    {
        using var cell = new FireCell(slots: Math.Clamp(Files / 50, 8, 60));
        var files = new FireFiles();
        var clock = Stopwatch.StartNew();
        var random = new Random(11);
        var (good, wanted) = (new List<(string Name, byte[] Bytes)>(), new Dictionary<string, string>(StringComparer.Ordinal));
        for (var i = 0; i < Files; i++)
        {
            var (name, bytes) = files.Next(cell.Slots[i % cell.Slots.Count], i);
            good.Add((name, bytes));
        }

        await using var machine = new FireMachine(cell, () => files.FileByProgram);
        cell.Start();
        var (cut, left) = (new List<string>(), new List<string>());
        for (var i = 0; i < Files; i++)
        {
            var (name, bytes) = good[i];
            var number = i.ToString("000000", CultureInfo.InvariantCulture);
            switch (random.Next(20))
            {
                case < 9:
                    cell.Drop(name, bytes);
                    wanted[name] = "released";
                    cut.Add(name);
                    break;
                case < 12:
                    // The second file of one content comes later by far more than the cell needs to see the first.
                    var (twin, twice) = cut.Count > 0 ? (cut[random.Next(cut.Count)], true) : ("", false);
                    var again = twice ? $"{twin[..3]}_9{number}.csv" : name;
                    cell.Drop(again, twice ? good[int.Parse(twin[4..10], CultureInfo.InvariantCulture)].Bytes : [1]);
                    wanted[again] = twice ? "refused already-known" : "refused";
                    break;
                case < 14:
                    cell.Drop($"stranger-{number}.csv", bytes);
                    wanted[$"stranger-{number}.csv"] = "refused unknown-piece";
                    break;
                case < 16:
                    cell.Drop(name, bytes.AsSpan(0, bytes.Length / 2));
                    wanted[name] = "refused";
                    break;
                case < 18:
                    cell.Drop(
                        name, Encoding.ASCII.GetBytes(Encoding.ASCII.GetString(bytes).Replace("2a,", "2a,NaN", StringComparison.Ordinal)));
                    wanted[name] = "refused";
                    break;
                case < 19:
                    var hostile = HostileNames[i % HostileNames.Length] + number + ".csv";
                    cell.Drop(hostile, bytes);
                    if (hostile.StartsWith('.'))
                    {
                        left.Add(hostile);
                    }
                    else
                    {
                        wanted[Shown(hostile)] = "refused unknown-piece";
                    }

                    break;
                default:
                    cell.Drop(name, Bomb(i));
                    wanted[name] = "refused";
                    break;
            }

            if (i == Files / 2)
            {
                Sparse(Path.Combine(cell.Folder, "huge"), 1L << 30);
                File.Move(Path.Combine(cell.Folder, "huge"), Path.Combine(cell.Incoming, "S00_999999.csv"));
                wanted["S00_999999.csv"] = "refused";
            }
        }

        await cell.Until(
            () => Task.FromResult(Directory.EnumerateFiles(cell.Incoming).Count() == left.Count && machine.Cut.Count == cut.Count),
            TimeSpan.FromSeconds(300 + (Files / 5)),
            "all files taken and cut");
        await cell.Until(
            async () => (await cell.History()).All(c => c.GetProperty("state").GetString() is "released" or "refused"),
            TimeSpan.FromMinutes(5),
            "an end for each");
        await cell.Stop();

        var history = await cell.History();
        Assert.Equal(wanted.Count, history.Count);
        var outcomes = history.ToDictionary(
            c => c.GetProperty("fileName").GetString()!,
            c => c.GetProperty("state").GetString() + (c.TryGetProperty("code", out var code) ? " " + code.GetString() : ""),
            StringComparer.Ordinal);
        Assert.All(wanted, w => Assert.StartsWith(w.Value, outcomes.GetValueOrDefault(w.Key, "lost: " + w.Key), StringComparison.Ordinal));

        // What begins with a point is a gauge's own until it gets another name: it stays where it is.
        Assert.NotEmpty(left);
        Assert.Equal(
            left.Order(StringComparer.Ordinal),
            Directory.EnumerateFiles(cell.Incoming).Select(f => Path.GetFileName(f)).Order(StringComparer.Ordinal));
        Assert.Empty(machine.Wrong);
        Assert.Equal(cut.Order(StringComparer.Ordinal), machine.Cut.Select(c => c.File).Order(StringComparer.Ordinal));
        Assert.False(File.Exists(cell["pwned"]));
        await cell.AuditHolds();
        TestContext.Current.TestOutputHelper!.WriteLine(
            $"{wanted.Count + left.Count} files, {cut.Count} of them cut, in {clock.Elapsed.TotalSeconds:0} s");
    }

    // What no eye sees is shown by a mark, or it would do to a terminal what its sender wants.
    private static string Shown(string name) =>
        string.Concat(name.Select(c => char.GetUnicodeCategory(c) is UnicodeCategory.Control or UnicodeCategory.Format ? '\uFFFD' : c));

    // Each a form that costs a careless reader much: one endless line, millions of lines, an archive, nothing.
    private static byte[] Bomb(int number) => (number % 5) switch
    {
        0 => Encoding.ASCII.GetBytes("point,x_mm,y_mm\n" + new string(',', 4_000_000)),
        1 => Encoding.ASCII.GetBytes("point,x_mm,y_mm\n" + string.Concat(Enumerable.Repeat("1,2,3\n", 500_000))),
        2 => [0x50, 0x4B, 3, 4, .. new byte[1000]],
        3 => [],
        _ => Encoding.ASCII.GetBytes("point,x_mm,y_mm\n1,=HYPERLINK(\"x\"),1e999\n"),
    };

    private static void Sparse(string path, long length)
    {
        using var file = File.OpenHandle(path, FileMode.CreateNew, FileAccess.Write);
        RandomAccess.SetLength(file, length);
    }
}
