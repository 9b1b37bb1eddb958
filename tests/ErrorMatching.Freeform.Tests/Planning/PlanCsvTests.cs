using System.Text;

namespace ErrorMatching.Freeform.Tests;

public sealed class PlanCsvTests
{
    [Fact]
    public void A_plan_is_one_line_a_point_in_the_order_of_measuring()
    {
        var plan = MeasuringPlanner.Plan(Surfaces.Quadratic((x, _) => x), Surfaces.Measuring(2, 2));
        var lines = Encoding.UTF8.GetString(PlanCsv.Write(plan)).Split('\n');
        Assert.Equal("point,i,j,x,y,z,nx,ny,nz,reason", lines[0]);
        Assert.Equal(6, lines.Length);

        // The shortest way goes along the two sides of 63 mm.
        Assert.Equal("1,0,1,0.000000,63.000000,0.000000,-0.707106781,0.000000000,0.707106781,end", lines[1]);
        Assert.Equal("2,0,0,0.000000,0.000000,0.000000,-0.707106781,0.000000000,0.707106781,end", lines[2]);
    }
}
