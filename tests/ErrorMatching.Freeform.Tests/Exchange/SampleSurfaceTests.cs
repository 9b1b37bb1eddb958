using ErrorMatching.Testing;

namespace ErrorMatching.Freeform.Tests;

public sealed class SampleSurfaceTests
{
    public static TheoryData<int> Designs => [1, 2, 3];

    [Theory]
    [MemberData(nameof(Designs))]
    public void A_sample_is_what_the_writer_writes_of_the_design(int number)
    {
        var (surface, path, write) = Of(number);
        var bytes = write(surface);
        if (Environment.GetEnvironmentVariable("UPDATE_SAMPLES") == "1")
        {
            File.WriteAllBytes(path, bytes);
        }

        Assert.Equal(bytes, File.ReadAllBytes(path));
    }

    [Theory]
    [MemberData(nameof(Designs))]
    public void A_sample_reads_as_the_formula_of_its_design(int number)
    {
        var (_, path, _) = Of(number);
        var read = SurfaceReader.Read(File.ReadAllBytes(path), path, entity: null, outsideIsUp: true);
        Assert.True(read.Region.IsWhole);
        for (var i = 0; i <= 20; i++)
        {
            for (var j = 0; j <= 20; j++)
            {
                var at = read.Spline.At(i / 20.0, j / 20.0).Position;
                Assert.Equal(75 * i / 20.0, at.X, 1e-12);
                Assert.Equal(63 * j / 20.0, at.Y, 1e-12);
                Assert.Equal(PaperDesign.Height(number, at.X, at.Y), at.Z, 1e-12);
                Assert.True(read.NormalAt(i / 20.0, j / 20.0).Z > 0);
            }
        }
    }

    private static (PartSurface Surface, string Path, Func<PartSurface, byte[]> Write) Of(int number) => number switch
    {
        1 => (PaperDesign.One, Repository.PathTo("samples", "surface-one", "surface.igs"), IgesWriter.Write),
        2 => (PaperDesign.Two, Repository.PathTo("samples", "surface-two", "surface.stp"), StepWriter.Write),
        _ => (PaperDesign.Three, Repository.PathTo("samples", "surface-three", "surface.igs"), IgesWriter.Write),
    };
}
