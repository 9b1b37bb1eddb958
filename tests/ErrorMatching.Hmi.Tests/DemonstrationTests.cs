using System.Text;
using ErrorMatching.Jobs;
using ErrorMatching.Testing;

namespace ErrorMatching.Hmi.Tests;

public sealed class DemonstrationTests
{
    [Fact]
    public void Each_of_its_first_hundred_parts_leads_to_a_proved_program()
    {
        var (job, part) = (Repository.PathTo("samples", "complex-mating", "job.json"), File.ReadAllText(Repository.PathTo("samples", "complex-mating", "part.csv")));
        Assert.DoesNotContain(Enumerable.Range(1, 100), serial => !Leads(serial));

        bool Leads(int serial)
        {
            var measured = Encoding.UTF8.GetBytes(DemoPart.Near(part, serial, DemoDay.SpreadMm));
            return MatingRun.Of(new(job), new() { Part = new("part.csv", measured) }, TestContext.Current.CancellationToken).Result?.Report.Proof.Holds ?? false;
        }
    }
}
