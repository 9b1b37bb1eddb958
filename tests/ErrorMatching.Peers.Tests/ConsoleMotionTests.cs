using System.Globalization;
using ErrorMatching.EndToEnd.Tests;
using ErrorMatching.Nc;

namespace ErrorMatching.Peers.Tests;

/// <summary>The CSV of <c>nc motion</c>, read as a script would, against LinuxCNC's own interpreter.</summary>
public sealed class ConsoleMotionTests
{
    private const string Header = "index,line,block,kind,x,y,z,cx,cy,cz,plane,turns,feed";

    [Theory]
    [InlineData(Topic.Turns)]
    [InlineData(Topic.Planes)]
    [InlineData(Topic.Units)]
    [InlineData(Topic.RotatedOffsets)]
    [InlineData(Topic.References)]
    [InlineData(Topic.CyclesInPlanes)]
    [InlineData(Topic.Subprograms)]
    [InlineData(Topic.Polar)]
    public async Task Printed_motions_agree_with_rs274(Topic topic)
    {
        Rs274.IsNeeded();
        var folder = Directory.CreateTempSubdirectory("errormatch-").FullName;
        try
        {
            var text = RandomProgram.Write(topic, seed: 7);
            await File.WriteAllTextAsync(Path.Combine(folder, "program.ngc"), text, TestContext.Current.CancellationToken);
            var run = await ConsoleRun.Of(folder, "nc", "motion", "program.ngc", "--dialect", "linuxcnc");
            Assert.Equal((0, ""), (run.Exit, run.Error));
            var rows = run.Output.TrimEnd('\n').Split('\n');
            Assert.Equal(Header, rows[0]);
            var peer = Rs274.Run(text);
            Assert.Null(peer.Refusal);
            Assert.Equal(peer.Motions.Count, rows.Length - 1);
            for (var i = 0; i < peer.Motions.Count; i++)
            {
                Compare(peer.Motions[i], i, rows[i + 1].Split(','));
            }
        }
        finally
        {
            Directory.Delete(folder, recursive: true);
        }
    }

    private static void Compare(PeerMotion peer, int index, string[] cells)
    {
        var kind = peer.Kind switch
        {
            MotionKind.Rapid => "rapid",
            MotionKind.Line => "line",
            MotionKind.ArcClockwise => "arc-cw",
            MotionKind.ArcCounterClockwise => "arc-ccw",
            _ => "probe"
        };
        string[] wanted = [Text(index), Text(peer.Line!.Value), "N" + Text(peer.Line.Value), kind, peer.Plane.ToString(), Text(peer.Turns)];
        Assert.Equal(wanted, new[] { cells[0], cells[1], cells[2], cells[3], cells[10], cells[11] });
        var tolerance = (0.5 * peer.ResolutionMm) + 1e-7;
        Assert.Equal(peer.End.X, Number(cells[4]), tolerance);
        Assert.Equal(peer.End.Y, Number(cells[5]), tolerance);
        Assert.Equal(peer.End.Z, Number(cells[6]), tolerance);
        if (peer.Kind is not (MotionKind.ArcClockwise or MotionKind.ArcCounterClockwise))
        {
            Assert.All(cells[7..10], c => Assert.Empty(c));
            return;
        }

        var (a, b) = peer.Plane switch { Geometry.CoordinatePlane.XY => (7, 8), Geometry.CoordinatePlane.ZX => (9, 7), _ => (8, 9) };
        Assert.Equal(peer.Center.X, Number(cells[a]), tolerance);
        Assert.Equal(peer.Center.Y, Number(cells[b]), tolerance);
        Assert.Equal(peer.Feed!.Value, Number(cells[12]), tolerance);
    }

    private static string Text(int number) => number.ToString(CultureInfo.InvariantCulture);

    private static double Number(string cell) => double.Parse(cell, CultureInfo.InvariantCulture);
}
