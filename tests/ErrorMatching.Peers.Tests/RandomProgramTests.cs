using System.Globalization;
using System.Text.RegularExpressions;
using ErrorMatching.Nc;

namespace ErrorMatching.Peers.Tests;

/// <summary>
/// Random programs, motion by motion against LinuxCNC's own interpreter. <c>ERRORMATCH_PEER_PROGRAMS</c> sets how many of each topic (5 if
/// not set), <c>ERRORMATCH_PEER_SEED</c> the first seed.
/// </summary>
public sealed class RandomProgramTests
{
    private static readonly int Programs = Setting("ERRORMATCH_PEER_PROGRAMS", 5);
    private static readonly int FirstSeed = Setting("ERRORMATCH_PEER_SEED", 1);

    [Theory]
    [InlineData(Topic.Lines)]
    [InlineData(Topic.ArcsByCenter)]
    [InlineData(Topic.ArcsByRadius)]
    [InlineData(Topic.Turns)]
    [InlineData(Topic.Planes)]
    [InlineData(Topic.Units)]
    [InlineData(Topic.Spelling)]
    [InlineData(Topic.Feeds)]
    [InlineData(Topic.WorkOffsets)]
    [InlineData(Topic.RotatedOffsets)]
    [InlineData(Topic.TouchedOffsets)]
    [InlineData(Topic.SetPositions)]
    [InlineData(Topic.LocalShifts)]
    [InlineData(Topic.MachineCoordinates)]
    [InlineData(Topic.ToolLengths)]
    [InlineData(Topic.References)]
    [InlineData(Topic.Cycles)]
    [InlineData(Topic.CyclesInPlanes)]
    [InlineData(Topic.Expressions)]
    [InlineData(Topic.Flow)]
    [InlineData(Topic.Subprograms)]
    [InlineData(Topic.Probes)]
    [InlineData(Topic.Splines)]
    [InlineData(Topic.Compensation)]
    [InlineData(Topic.Polar)]
    [InlineData(Topic.OddBlocks)]
    [InlineData(Topic.SavedModes)]
    [InlineData(Topic.Everything)]
    public void Motions_agree_with_rs274(Topic topic)
    {
        Rs274.IsNeeded();
        var differences = new List<string>();
        for (var seed = FirstSeed; seed < FirstSeed + Programs; seed++)
        {
            var text = RandomProgram.Write(topic, seed);
            BlockSkip[] positions = text.Contains("\n/", StringComparison.Ordinal) ? [BlockSkip.Off, BlockSkip.On] : [BlockSkip.Unstated];
            foreach (var position in positions)
            {
                var peer = Rs274.Run(WithoutCompensation(text), position == BlockSkip.On);
                Assert.True(peer.Refusal is null, $"seed {seed}, block skip {position}: rs274 refuses the program, {peer.Refusal}\n{text}");
                var path = NcInterpreter.Run(NcProgram.FromText(text, NcDialects.LinuxCnc.Syntax), NcDialects.LinuxCnc.With(position));
                if (Agreement.FirstDifference(peer.Motions, path) is { } difference)
                {
                    differences.Add($"seed {seed}, block skip {position}: {difference}\n{text}");
                }
            }
        }

        Assert.True(differences.Count == 0, $"{differences.Count} of {Programs} programs differ, first {differences.FirstOrDefault()}");
    }

    // Our motions are the programmed path; the peer's would be the compensated one.
    private static string WithoutCompensation(string text) =>
        Regex.Replace(text, @"G4[12](\.1)? D[0-9.]+", "G40", RegexOptions.ExplicitCapture, TimeSpan.FromSeconds(1));

    private static int Setting(string name, int otherwise) =>
        Environment.GetEnvironmentVariable(name) is { } text ? int.Parse(text, CultureInfo.InvariantCulture) : otherwise;
}
