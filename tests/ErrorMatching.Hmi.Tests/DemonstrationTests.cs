using System.Text;
using ErrorMatching.Cell;
using ErrorMatching.Jobs;
using ErrorMatching.Testing;

namespace ErrorMatching.Hmi.Tests;

public sealed class DemonstrationTests
{
    [Fact]
    public void Each_of_its_first_hundred_parts_leads_to_a_proved_program()
    {
        var (job, part) = (
            Repository.PathTo("samples", "complex-mating", "job.json"),
            File.ReadAllText(Repository.PathTo("samples", "complex-mating", "part.csv")));
        Assert.DoesNotContain(Enumerable.Range(1, 100), serial => !Leads(serial));

        bool Leads(int serial)
        {
            var measured = Encoding.UTF8.GetBytes(DemoPart.Near(part, serial, DemoDay.SpreadMm));
            return MatingRun.Run(
                new(job), new() { Part = new("part.csv", measured) }, TestContext.Current.CancellationToken).Result?.Report.Proof.Holds
                ?? false;
        }
    }

    [Fact]
    public Task What_its_machine_cuts_is_what_was_predicted_of_the_program_that_was_sent() => Seat.AtAsync(seat =>
    {
        using var end = CancellationTokenSource.CreateLinkedTokenSource(TestContext.Current.CancellationToken);
        seat.Cell.Run();
        var day = Task.Run(() => new DemoDay(seat.Cell, TimeProvider.System).RunAsync(end.Token), TestContext.Current.CancellationToken);
        seat.WaitFor(1, CorrectionState.Proposed);
        new CorrectionDecisions(seat.Station.Store).Approve(1, DemoCell.Setter, null);
        seat.WaitFor(1, CorrectionState.Verified);
        seat.Cell.FinishPiece();
        StoredPiece? piece = null;
        seat.WaitFor(
            () => (
                piece = new StoredPieces().Read(
                    seat.Station.Store, [.. seat.Station.Settings.Jobs.Select(j => j.Name)], 100).FirstOrDefault(p => p.IsMeasured))
                is not null,
            "The counterpart is not measured.");
        end.Cancel();
        Assert.True(day.Wait(Seat.Patience, TestContext.Current.CancellationToken));

        // A machine repeats to within a micrometer in either coordinate, and the same figures are rounded to a tenth of that.
        Assert.Equal(16, piece!.Misses.Count);
        Assert.All(piece.Misses, m => Assert.InRange(Math.Abs(m.Mm), 1e-9, (DemoDay.CutSpreadMm + 0.0001) * Math.Sqrt(2)));
        Assert.DoesNotContain(piece.Misses, m => m.IsSignificant);
    });
}
