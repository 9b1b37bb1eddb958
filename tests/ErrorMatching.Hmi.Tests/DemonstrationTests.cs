using System.Text;
using ErrorMatching.Jobs;
using ErrorMatching.Testing;

namespace ErrorMatching.Hmi.Tests;

public sealed class DemonstrationTests
{
    [Fact]
    public void Of_its_first_hundred_parts_one_is_refused_and_the_others_lead_to_proved_programs()
    {
        var (job, part) = (Repository.PathTo("samples", "complex-mating", "job.json"), File.ReadAllText(Repository.PathTo("samples", "complex-mating", "part.csv")));
        var refused = Enumerable.Range(1, 100).Where(serial => !Leads(serial)).ToArray();

        // Whole thousandths cannot say the arc of N140 for part 97 closely enough: that is refused, and looks like it.
        Assert.Equal([97], refused);

        bool Leads(int serial)
        {
            var measured = Encoding.UTF8.GetBytes(DemoPart.Near(part, serial, DemoDay.SpreadMm));
            return MatingRun.Of(new(job), new() { Part = new("part.csv", measured) }, TestContext.Current.CancellationToken).Result?.Report.Proof.Holds ?? false;
        }
    }
}
