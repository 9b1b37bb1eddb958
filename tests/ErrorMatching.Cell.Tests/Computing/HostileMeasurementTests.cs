using System.Text;
using ErrorMatching.Testing;

namespace ErrorMatching.Cell.Tests;

public sealed class HostileMeasurementTests
{
    public static TheoryData<string> Contents => [
        "", "\0", "\n\n\n", "point,x_mm,y_mm", "point,x_mm,y_mm\n1,NaN,2\n", "point,x_mm,y_mm\n1,1e999,2\n", "point,x_mm,y_mm\n\"",
        "%PDF-1.7", "{}", "<a/>", "point,x,y,z\n1,=cmd(),2,3\n"];

    [Theory]
    [MemberData(nameof(Contents))]
    public void What_is_no_measurement_is_refused_with_code_and_reason(string content)
    {
        foreach (var request in new[]
        {
            Samples.Part("complex-mating"),
            Samples.Part("complex-mating") with { Piece = "counterpart" },
            Samples.Surface("surface-one")
        })
        {
            var refused = Samples.Refusal(request with { Measurement = new("../../etc/x.csv", Encoding.UTF8.GetBytes(content)) });
            Assert.Matches("^[a-z]+(-[a-z]+)*$", refused.Code);
            Assert.Contains("x.csv", refused.Reason.Sentence, StringComparison.Ordinal);
            Assert.False(refused.MayPass);
        }
    }

    [Fact]
    public void A_name_with_folders_reads_nothing()
    {
        using var folder = new TemporaryFolder();
        var file = folder.File("part.csv", "not a measurement");
        var request = Samples.Part("complex-mating");
        Assert.Equal(
            Samples.Program(request).Program.ToArray(),
            Samples.Program(request with { Measurement = request.Measurement with { Name = file } }).Program.ToArray());
    }

    [Theory]
    // A surface takes long to compute. Its readers are tried by themselves much more often (MutationTests).
    [InlineData("complex-mating", 1, 300)]
    [InlineData("surface-one", 2, 100)]
    public void A_damaged_measurement_is_a_program_or_a_refusal_and_never_a_crash(string sample, int seed, int mutations)
    {
        var request = CorrectionComputerTests.Request(sample);
        var random = new Random(seed);
        var refusals = 0;
        for (var i = 0; i < mutations; i++)
        {
            var computation = Samples.Compute(
                request with { Measurement = request.Measurement with { Bytes = Damaged(request.Measurement.Bytes.ToArray(), random) } },
                Samples.NoLimits with { LimitMm = 0.15 });
            refusals += computation is RefusedComputation ? 1 : 0;
            Assert.True(
                computation is ComputedProgram or RefusedComputation { Code.Length: > 0, Reason.Sentence.Length: > 0, MayPass: false });
        }

        Assert.InRange(refusals, mutations / 2, mutations);
    }

    // Bytes replaced, removed, repeated and cut off, as disks, cables and spreadsheets do it.
    private static byte[] Damaged(byte[] bytes, Random random)
    {
        var text = "0123456789.,;-+eE\n\r\t\"\0=NaInfy\u00ff"u8;
        var damaged = bytes.ToList();
        for (var times = random.Next(1, 4); times > 0 && damaged.Count > 0; times--)
        {
            var at = random.Next(damaged.Count);
            var most = Math.Min(damaged.Count - at, random.Next(1, 60));
            switch (random.Next(5))
            {
                case 0:
                    damaged[at] = text[random.Next(text.Length)];
                    break;
                case 1:
                    damaged.RemoveRange(at, most);
                    break;
                case 2:
                    damaged.InsertRange(at, damaged.GetRange(at, most));
                    break;
                case 3:
                    damaged.RemoveRange(at, damaged.Count - at);
                    break;
                default:
                    damaged.Insert(at, text[random.Next(text.Length)]);
                    break;
            }
        }

        return [.. damaged];
    }
}
