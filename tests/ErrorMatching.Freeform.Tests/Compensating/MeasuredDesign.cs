using System.Runtime.InteropServices;
using System.Security.Cryptography;
using System.Text;
using ErrorMatching.Geometry;
using ErrorMatching.Refusals;

namespace ErrorMatching.Freeform.Tests;

/// <summary>A design of the paper with an error of one's choice, measured.</summary>
internal sealed class MeasuredDesign
{
    public MeasuredDesign(PartSurface surface, string change = "", string to = "")
    {
        Surface = surface;
        Job = FreeformJob.Parse(
            Encoding.UTF8.GetBytes(
                change.Length == 0 ? FreeformTemplate.Text : FreeformTemplate.Text.Replace(change, to, StringComparison.Ordinal)),
            "job.json");
        Plan = MeasuringPlanner.Plan(surface, Job.Measuring, Job.Stock.Of(Job.Measuring.After));
    }

    private MeasuredDesign(MeasuredDesign other, FreeformJob job) => (Surface, Job, Plan) = (other.Surface, job, other.Plan);

    /// <summary>A linear error, in millimeters.</summary>
    public static double Tilted(double u, double v) => 0.01 + (0.012 * u) + (0.008 * v);

    public PartSurface Surface { get; }

    public FreeformJob Job { get; }

    public MeasuringPlan Plan { get; }

    /// <summary>The same design and plan with another job.</summary>
    public MeasuredDesign With(FreeformJob job) => new(this, job);

    /// <summary>The points of a piece whose error is a function of u and v, in millimetres, on the stock of the job's stage.</summary>
    public MeasuredPoints With(Func<double, double, double> error, string file = "measured.csv") =>
        Over(Job.Stock.Of(Job.Measuring.After), error, file);

    /// <summary>The same on another stock.</summary>
    public MeasuredPoints Over(double stock, Func<double, double, double> error, string file = "measured.csv")
    {
        MeasuredPoint[] points = [
            .. Plan.Points.Select((p, i) => new MeasuredPoint(p, p.Position + (p.Normal * (stock + error(p.U, p.V))), i + 2))];
        return new(
            file,
            Convert.ToHexStringLower(SHA256.HashData(MemoryMarshal.AsBytes<Point3>(points.Select(p => p.Contact).ToArray()))),
            points,
            []);
    }

    public Outcome<CompensationResult> Compensate(params MeasuredPoints[] measured) =>
        Compensator.Compensate(new(Job, Surface, Plan, measured));

    /// <summary>Largest distance of a surface from the nominal one moved by -gain error, at the same parameters.</summary>
    public double Off(SplineSurface surface, Func<double, double, double> error, double gain = 1)
    {
        var largest = 0.0;
        for (var i = 0; i <= 40; i++)
        {
            for (var j = 0; j <= 40; j++)
            {
                var (u, v) = (i / 40.0, j / 40.0);
                var wanted = Surface.Spline.PointAt(u, v) + (Surface.NormalAt(u, v) * (-gain * error(u, v)));
                largest = Math.Max(largest, (surface.PointAt(u, v) - wanted).Length);
            }
        }

        return largest;
    }
}
