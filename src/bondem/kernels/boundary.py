"""Prescribed motion and loads: a few rows, updated once a step by one thread."""

from bondem._compile import device, kernel


@device
def interpolate(times, values, first, last, t):
    """Value of a piecewise linear schedule at time t, constant beyond its ends; of a jump, the later value."""
    if t < times[first]:
        return values[first]
    k = first
    while k + 1 < last and times[k + 1] <= t:
        k += 1
    if k + 1 >= last:
        return values[last - 1]
    return values[k] + (values[k + 1] - values[k]) * ((t - times[k]) / (times[k + 1] - times[k]))


@kernel(parallel=False)
def apply_schedules(
    t, dt, times, values, start, drive_row, drive_dof, drive_schedule, drive_rate,
    load_row, load_schedule, load_value, row_force, row_half, row_full,
):  # fmt: skip
    """Set the rows' forces at time t, their velocities at t, and those over the step from t to t + dt."""
    row_force[:] = 0.0
    for e in range(len(load_row)):
        s = load_schedule[e]
        amplitude = interpolate(times, values, start[s], start[s + 1], t)
        for d in range(6):
            row_force[load_row[e], d] += amplitude * load_value[e, d]
    for e in range(len(drive_row)):
        s = drive_schedule[e]
        r, d = drive_row[e], drive_dof[e]
        if drive_rate[e]:
            row_full[r, d] = interpolate(times, values, start[s], start[s + 1], t)
            row_half[r, d] = interpolate(times, values, start[s], start[s + 1], t + 0.5 * dt)
        else:
            now = interpolate(times, values, start[s], start[s + 1], t)
            row_half[r, d] = (interpolate(times, values, start[s], start[s + 1], t + dt) - now) / dt
            row_full[r, d] = row_half[r, d]
