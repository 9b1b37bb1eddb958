using System.Security.Cryptography;
using System.Text;
using System.Text.RegularExpressions;
using ErrorMatching.Nc;
using ErrorMatching.Testing;

namespace ErrorMatching.Peers.Tests;

/// <summary>The programs that come with LinuxCNC, motion by motion against its own interpreter, up to the block that this refuses,
/// if it does.</summary>
public sealed partial class PackageProgramTests
{
    private static readonly int FewestPrograms = Depth.Of(35, 40);

    private static readonly string[] Folders = [
        "/usr/share/linuxcnc/ncfiles", "/usr/share/doc/linuxcnc/examples", "/usr/share/axis/images"];

    // Programs that are not compared, each with the reason.
    private static readonly Dictionary<string, string> Excluded = new(StringComparer.Ordinal)
    {
        ["gmoccapy_2_tools_with_cutter_radius_compensation.ngc"] = "rs274 takes the tool's length from its own tool table.",
        ["lathe_g70_71_demo.ngc"] = "Turning cycles are not followed: the dialect states so.",
        ["lathe_g7x_face_boring.ngc"] = "Turning cycles are not followed: the dialect states so.",
        ["lathe_g7x_quadrants.ngc"] = "Turning cycles are not followed: the dialect states so.",
        ["smartprobe.ngc"] = "It loops on the result of probing, which only the machine knows; it is refused.",
    };

    [Fact]
    public void Motions_of_the_package_s_programs_agree_with_rs274()
    {
        Rs274.IsNeeded();
        var files = Folders.Where(Directory.Exists)
            .SelectMany(f => Directory.EnumerateFiles(f, "*.ngc", SearchOption.AllDirectories))
            .Where(f => !Excluded.ContainsKey(Path.GetFileName(f)))
            .Where(f => new FileInfo(f).Length <= Depth.Of(60_000, int.MaxValue))
            .Order(StringComparer.Ordinal)
            .DistinctBy(f => Convert.ToHexString(SHA256.HashData(File.ReadAllBytes(f))))
            .ToArray();
        var (compared, differences) = (0, new List<string>());
        foreach (var file in files)
        {
            var bytes = File.ReadAllBytes(file);
            var peer = Rs274.Run(Numbered(Encoding.Latin1.GetString(bytes)), Path.GetDirectoryName(file)!);
            if (peer.Motions.Count == 0)
            {
                continue;
            }

            compared++;
            var dialect = NcDialects.LinuxCnc.With(BlockSkip.Off);
            NcProgram? Library(string name) => InFolder(Path.GetDirectoryName(file)!, name);
            var path = NcInterpreter.Run(NcProgram.Read(bytes, dialect.Syntax), dialect, Library, TestContext.Current.CancellationToken);
            if (Agreement.FirstDifference(peer.Motions, path, mostUnknown: 1, peerStops: peer.Refusal is not null) is { } difference)
            {
                differences.Add($"{file}: {difference}");
            }
        }

        Assert.True(compared >= FewestPrograms, $"rs274 moves in only {compared} of {files.Length} programs.");
        Assert.True(differences.Count == 0, $"{differences.Count} of {compared} programs differ:\n{string.Join('\n', differences)}");
    }

    // The peer looks for called programs where it runs.
    private static NcProgram? InFolder(string folder, string name)
    {
        var file = Path.Combine(folder, name + ".ngc");
        return File.Exists(file) ? NcProgram.Read(File.ReadAllBytes(file), NcDialects.LinuxCnc.Syntax) : null;
    }

    // The peer prints the N word of a motion's block: each block gets its line as one.
    // Compensation is blanked, since ours is the programmed path.
    private static string Numbered(string text)
    {
        var lines = text.Split('\n');
        for (var i = 0; i < lines.Length; i++)
        {
            lines[i] = Compensation().Replace(lines[i], "G40");
            lines[i] = Begin().Replace(lines[i], $"N{i + 1} ${{rest}}");
        }

        return string.Join('\n', lines);
    }

    [GeneratedRegex(
        @"G\s*4[12](\.1)?(?![0-9])(\s*D\s*(\[[^\]]*\]|#<[^>]*>|[#0-9.]+))?", RegexOptions.IgnoreCase | RegexOptions.ExplicitCapture, 1000)]
    private static partial Regex Compensation();

    [GeneratedRegex(
        @"^\s*(N\s*[0-9]+)?\s*(?<rest>[A-MP-Z].*)$",
        RegexOptions.IgnoreCase | RegexOptions.ExplicitCapture | RegexOptions.Singleline,
        1000)]
    private static partial Regex Begin();
}
