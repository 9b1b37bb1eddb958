using System.Text;
using ErrorMatching.Refusals;

namespace ErrorMatching.Freeform.Tests;

public sealed class NoSurfaceTests
{
    [Theory]
    [InlineData("part.stl", "solid part\nfacet normal 0 0 1\nendsolid\n", "mesh-as-surface")]
    [InlineData("part.igs", "\n  solid part\nfacet normal 0 0 1\nendsolid\n", "mesh-as-surface")]
    [InlineData("part.OBJ", "v 0 0 0\n", "mesh-as-surface")]
    [InlineData("part.csv", "x,y,z\n0,0,1\n", "cloud-as-surface")]
    [InlineData("part.csv", "point;X;Y;z_mm\n1;0;0;1\n", "cloud-as-surface")]
    [InlineData("part.csv", "i,x,y,z\n1,0,0,1\n", "missing-column")]
    [InlineData("part.csv", "a,b\n1,0\n", "missing-column")]
    [InlineData("part.igs", "solid part\n", "bad-record")]
    public void A_mesh_or_a_cloud_is_named_with_what_to_export(string file, string text, string code)
    {
        var error = Refused(Encoding.UTF8.GetBytes(text), file);
        Assert.Equal((code, file, 1), (error.Code, error.File, error.Place.Line));
        Assert.Equal(code is "mesh-as-surface" or "cloud-as-surface", error.Message.Contains("STEP or IGES", StringComparison.Ordinal));
    }

    [Fact]
    public void A_binary_mesh_is_recognized_by_its_length()
    {
        var mesh = new byte[84 + (2 * 50)];
        mesh[80] = 2;
        Assert.Equal("mesh-as-surface", Refused(mesh, "part.stp").Code);
        Assert.NotEqual("mesh-as-surface", Refused([.. mesh, 0], "part.stp").Code);
    }

    private static InputException Refused(byte[] bytes, string file) =>
        Assert.Throws<InputException>(() => SurfaceReader.Read(bytes, file, entity: null, outsideIsUp: true));
}
