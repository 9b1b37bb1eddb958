using FsCheck;
using FsCheck.Fluent;

namespace ErrorMatching.Cell.Tests;

public sealed class SlotLineTests
{
    [Theory]
    [InlineData("S9", "S10")]
    [InlineData("A-2-10", "A-10-2")]
    [InlineData("007", "8")]
    [InlineData("7", "007")]
    [InlineData("S", "S1")]
    [InlineData("99999999999999999999999999998", "99999999999999999999999999999")]
    [InlineData("S1", null)]
    public void Serial_numbers_are_counted_as_people_count(string first, string? second)
    {
        Assert.Equal(first == "7" ? 1 : -1, Math.Sign(SerialOrder.Instance.Compare(first, second)));
        Assert.Equal(first == "7" ? -1 : 1, Math.Sign(SerialOrder.Instance.Compare(second, first)));
    }

    [Fact]
    public void The_order_of_serial_numbers_is_one() => Prop.ForAll(
        ArbMap.Default.ArbFor<string>().Generator.Where(s => s is not null).Three().ToArbitrary(),
        t =>
        {
            var order = SerialOrder.Instance;
            Assert.Equal(Math.Sign(order.Compare(t.Item1, t.Item2)), -Math.Sign(order.Compare(t.Item2, t.Item1)));
            Assert.Equal(t.Item1 == t.Item2, order.Compare(t.Item1, t.Item2) == 0);
            Assert.False(
                order.Compare(t.Item1, t.Item2) < 0 && order.Compare(t.Item2, t.Item3) < 0 && order.Compare(t.Item1, t.Item3) >= 0);
        }).QuickCheckThrowOnFailure();

    [Fact]
    public void The_line_keeps_the_order_of_arrival() =>
        Assert.Equal([1L, 2, 3], SlotLine.Order([Of(1, "S3"), Of(2, "S1"), Of(3, "S2")], _ => false).Select(c => c.Id));

    [Fact]
    public void A_job_by_serial_number_sorts_its_own_pieces_only() =>
        Assert.Equal(
            [2L, 1, 3, 4],
            SlotLine.Order([Of(1, "S3"), Of(2, "S1"), Of(3, "S9", "other"), Of(4, "S4")], j => j == "job").Select(c => c.Id));

    [Fact]
    public void The_order_is_who_is_first_again_and_again() => Prop.ForAll(
        Gen.Elements(0, 1, 2, 3).Two().ListOf().ToArbitrary(),
        pieces =>
        {
            List<Correction> rest = [.. pieces.Select((p, i) => Of(i, $"S{p.Item1}", p.Item2 < 2 ? "job" : $"other{p.Item2}"))];
            var order = SlotLine.Order([.. rest], IsBySerial);
            Assert.Equal(rest.Count, order.Count);
            Assert.All(order, c =>
            {
                Assert.Same(SlotLine.First(rest, IsBySerial), c);
                rest.Remove(c);
            });

            static bool IsBySerial(string job) => job != "other2";
        }).QuickCheckThrowOnFailure();

    private static Correction Of(long id, string serial, string job = "job") =>
        new(id, CorrectionState.Approved, 1, "gauge", "file", DateTimeOffset.UnixEpoch, "", 0) { Job = job, Serial = serial };
}
