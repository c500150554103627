namespace Penumbra.Tests;

public class UpdateScheduleTests
{
    private static float[] Numbers(Vector4 of) => new[] { of.x, of.y, of.z, of.w };

    
    [Test]
    public void PhasesAreThoseOfTheFile()
    {
        var records = GoldenRecord.Of("schedules").ToList();
        Assert.That(records.Count, Is.GreaterThanOrEqualTo(54));
        foreach (GoldenRecord record in records)
        {
            float[] periods = Numbers(record.Vector("periods"));
            float[] phases = Numbers(record.Vector("phases"));
            var schedule = new UpdateSchedule(
                Enumerable.Range(0, record.Int("cascades")).Select(i => (int)periods[i]).ToArray());
            Assert.That(schedule.Cascades, Is.EqualTo(record.Int("cascades")), record.Label);
            for (var i = 0; i < schedule.Cascades; ++i)
            {
                Assert.That(schedule.Period(i), Is.EqualTo((int)periods[i]), record.Label);
                Assert.That(schedule.Phase(i), Is.EqualTo((int)phases[i]), record.Label);
            }
            Assert.That(schedule.Due(record.Int("frame")), Is.EqualTo(record.Int("due")), record.Label);
        }
    }

    [Test]
    public void NoOtherPhasesNeedFewerCascadesInAFrame()
    {
        var choices = new[] { 1, 2, 4, 8 };
        for (var i = 0; i < 256; ++i)
        {
            int[] periods = { choices[i & 3], choices[i >> 2 & 3], choices[i >> 4 & 3], choices[i >> 6 & 3] };
            var schedule = new UpdateSchedule(periods);
            int most = Enumerable.Range(0, 8).Max(frame => System.Numerics.BitOperations.PopCount((uint)schedule.Due(frame)));
            Assert.That(most, Is.EqualTo(FewestPossible(periods)), string.Join(", ", periods));
        }
    }

    // The largest number of cascades in a frame that the best phases give, by trying every combination of phases.
    private static int FewestPossible(int[] periods)
    {
        int combinations = periods.Aggregate(1, (product, period) => product * period);
        int fewest = periods.Length;
        for (var combination = 0; combination < combinations; ++combination)
        {
            var due = new int[8];
            int rest = combination;
            foreach (int period in periods)
            {
                for (int frame = rest % period; frame < 8; frame += period) ++due[frame];
                rest /= period;
            }
            fewest = Math.Min(fewest, due.Max());
        }
        return fewest;
    }

    [TestCase(0, 1)]
    [TestCase(-5, 1)]
    [TestCase(3, 2)]
    [TestCase(100, 64)]
    [TestCase(int.MaxValue, 64)]
    public void OtherPeriodsAreRoundedDown(int given, int period) =>
        Assert.That(new UpdateSchedule(given).Period(0), Is.EqualTo(period));

    [TestCase(2)]
    [TestCase(-1)]
    [TestCase(int.MaxValue)]
    public void ACascadeThatItLacksIsAlwaysDue(int cascade)
    {
        Assert.That(new UpdateSchedule(1, 2).IsDue(cascade, 7));
        Assert.That(default(UpdateSchedule).IsDue(cascade, 7));
    }

    [Test]
    public void NoMoreThanFourCascadesCount()
    {
        Assert.That(new UpdateSchedule(1, 1, 1, 1, 1).Due(0), Is.EqualTo(15));
        Assert.That(new UpdateSchedule().Due(0), Is.EqualTo(0));
    }
}
